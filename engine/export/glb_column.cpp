#include "engine/export/glb_column.h"

#include <fmt/format.h>

namespace tractus {

static std::string accessor_text(NumberFormat const& format, std::size_t count,
                                 std::string_view more)
{
    constexpr char const* kTypes[] = { "", "SCALAR", "VEC2", "VEC3", "VEC4" };
    return fmt::format("\"componentType\":{},\"count\":{},\"type\":\"{}\"{}{}}}",
                       static_cast<int>(format.type), count, kTypes[format.components],
                       format.normalized ? ",\"normalized\":true" : "", more);
}

GlbColumn open_column(GlbStream& stream, NumberFormat const& format, std::size_t count)
{
    return { format, count,
             stream.open_block(count * static_cast<std::size_t>(format.element_bytes)) };
}

std::size_t add_accessor(GltfJson& json, GlbColumn const& column, int target, std::string_view more)
{
    auto const& [format, count, block] = column;
    auto const target_text
        = target == kNoTarget ? std::string() : fmt::format(",\"target\":{}", target);
    // Elements that are padded to four bytes say how far they are apart.
    bool const is_padded = format.components == 3 && format.type != ComponentType::Float;
    auto const stride
        = is_padded ? fmt::format(",\"byteStride\":{}", format.element_bytes) : std::string();
    auto const view = json.buffer_views.add(
        fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}{}{}}}", block.start,
                    block.size, stride, target_text));
    return json.accessors.add(
        fmt::format("{{\"bufferView\":{},{}", view, accessor_text(format, count, more)));
}

std::size_t add_zeros(GltfJson& json, NumberFormat const& format, std::size_t count,
                      std::string_view more)
{
    return json.accessors.add(fmt::format("{{{}", accessor_text(format, count, more)));
}

// As doubles: the decimal that is exactly the float.
std::string limits_text(Vec3f const& low, Vec3f const& high)
{
    Vec3 const l = low.cast<double>();
    Vec3 const h = high.cast<double>();
    return fmt::format(",\"min\":[{},{},{}],\"max\":[{},{},{}]", l.x(), l.y(), l.z(), h.x(), h.y(),
                       h.z());
}

} // namespace tractus
