#include "engine/export/glb_column.h"

#include "engine/base/check.h"

#include <utility>

namespace tractus::exports {

static Json accessor_json(NumberFormat const& format, std::size_t count)
{
    constexpr char const* kTypes[] = { "", "SCALAR", "VEC2", "VEC3", "VEC4" };
    Json accessor {
        { "componentType", static_cast<int>(format.type) },
        { "count", count },
        { "type", kTypes[format.components] },
    };
    if (format.normalized)
        accessor["normalized"] = true;
    return accessor;
}

GlbColumn open_column(GlbStream& stream, NumberFormat const& format, std::size_t count)
{
    return { format, count,
             stream.open_block(count * static_cast<std::size_t>(format.element_bytes)) };
}

GlbColumn open_compressed_column(GlbStream& stream, GltfJson& json, NumberFormat const& format,
                                 std::size_t count, std::size_t compressed_bytes)
{
    GlbColumn const column { format, count, stream.open_block(compressed_bytes),
                             json.fallback_bytes };
    json.required_extensions.insert("EXT_meshopt_compression");
    json.fallback_bytes += (count * column.element_bytes() + 3) / 4 * 4;
    return column;
}

static Json compression_json(GlbColumn const& column)
{
    bool const are_indices = column.format.codec == Codec::Indices;
    Json compression { { "buffer", 0 },
                       { "byteOffset", column.block.start },
                       { "byteLength", column.block.size },
                       { "byteStride", column.element_bytes() },
                       { "count", column.count },
                       { "mode", are_indices ? "INDICES" : "ATTRIBUTES" } };
    if (column.format.codec == Codec::Octahedral)
        compression["filter"] = "OCTAHEDRAL";
    if (column.format.codec == Codec::Exponential)
        compression["filter"] = "EXPONENTIAL";
    return { { "EXT_meshopt_compression", std::move(compression) } };
}

static std::size_t add_view(GltfJson& json, GlbColumn const& column, Json const& more)
{
    if (!column.decompressed_start)
        return add_view(json, column.block, more);
    Json view { { "buffer", 1 },
                { "byteOffset", *column.decompressed_start },
                { "byteLength", column.count * column.element_bytes() } };
    view.update(more);
    view["extensions"] = compression_json(column);
    return json.buffer_views.add(view);
}

std::size_t add_view(GltfJson& json, GlbStream::Block const& block, Json const& more)
{
    Json view { { "buffer", 0 }, { "byteOffset", block.start }, { "byteLength", block.size } };
    view.update(more);
    return json.buffer_views.add(view);
}

std::size_t add_accessor(GltfJson& json, GlbColumn const& column, int target, Json const& more)
{
    auto const& format = column.format;
    auto of_view = Json::object();
    // Elements that are padded to a multiple of four bytes need an explicit stride.
    if (format.components == 3 && format.type != ComponentType::Float)
        of_view["byteStride"] = format.element_bytes;
    if (target != kNoTarget)
        of_view["target"] = target;
    Json accessor;
    accessor["bufferView"] = add_view(json, column, of_view);
    accessor.update(accessor_json(format, column.count));
    accessor.update(more);
    return json.accessors.add(accessor);
}

std::size_t add_zeros(GltfJson& json, NumberFormat const& format, std::size_t count,
                      Json const& more)
{
    auto accessor = accessor_json(format, count);
    accessor.update(more);
    return json.accessors.add(accessor);
}

// Limits are converted to doubles, so that the decimal numbers in the file are exactly those of the
// floats.
Json limits_json(Vec3f const& low, Vec3f const& high)
{
    return { { "min", json_numbers(low.cast<double>().eval()) },
             { "max", json_numbers(high.cast<double>().eval()) } };
}

Json add_triangles(GltfJson& json, std::span<GlbColumn const> columns, EncodedPiece const& limits)
{
    CHECK(columns.size() >= kTriangleColumns);
    Json attributes;
    attributes["POSITION"]
        = add_accessor(json, columns[0], kArrayBuffer, limits_json(limits.low, limits.high));
    attributes["NORMAL"] = add_accessor(json, columns[1], kArrayBuffer);
    attributes["TEXCOORD_0"] = add_accessor(json, columns[2], kArrayBuffer);
    auto const indices = add_accessor(json, columns[3], kElementArrayBuffer);
    if (columns[4].count > 0)
        attributes["TANGENT"] = add_accessor(json, columns[4], kArrayBuffer);
    return { { "attributes", std::move(attributes) }, { "indices", indices } };
}

} // namespace tractus::exports
