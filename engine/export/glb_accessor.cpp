#include "engine/export/glb_accessor.h"

#include "engine/export/tinygltf.h"

#include <algorithm>
#include <cstring>
#include <fmt/core.h>
#include <limits>

namespace tractus::exports {
namespace {

// Location and number format of an accessor's elements.
struct Elements {
    unsigned char const* first;
    std::size_t stride;
    std::size_t count;
    int component_type;
    bool normalized;
};

auto fail_at(int accessor, char const* reason)
{
    return fail(Fault::User,
                fmt::format("cannot read the glTF file: accessor {} {}", accessor, reason));
}

// Returns the sum of two sizes, or the largest number if it would overflow.
std::uint64_t sum(std::uint64_t a, std::uint64_t b)
{
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}

Result<Elements> find_elements(tinygltf::Model const& model, int index, int components)
{
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
        return fail_at(index, "does not exist");
    auto const& accessor = model.accessors[static_cast<std::size_t>(index)];
    auto const component_bytes
        = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    if (component_bytes <= 0
        || tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type))
            != components)
        return fail_at(index, "has the wrong type");
    if (accessor.sparse.isSparse)
        return fail_at(index, "is sparse, which is not supported");
    if (accessor.bufferView < 0
        || static_cast<std::size_t>(accessor.bufferView) >= model.bufferViews.size())
        return fail_at(index, "has no buffer view");
    auto const& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
        return fail_at(index, "has no buffer");
    auto const& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;

    auto const element_bytes
        = static_cast<std::uint64_t>(component_bytes) * static_cast<std::uint64_t>(components);
    std::uint64_t const stride = view.byteStride > 0 ? view.byteStride : element_bytes;
    if (stride < element_bytes || stride > 252)
        return fail_at(index, "has an impossible stride");
    if (accessor.count == 0 || accessor.count > bytes.size())
        return fail_at(index, "has an impossible count");
    std::uint64_t const end
        = sum(accessor.byteOffset, stride * (accessor.count - 1) + element_bytes);
    if (end > view.byteLength || sum(view.byteOffset, view.byteLength) > bytes.size())
        return fail_at(index, "reaches beyond its buffer: the file is damaged");
    return Elements { bytes.data() + view.byteOffset + accessor.byteOffset, stride, accessor.count,
                      accessor.componentType, accessor.normalized };
}

template<typename Number> Number load(unsigned char const* bytes)
{
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

// Reads a number. A normalised integer is converted to -1…1 if signed, otherwise to 0…1 (glTF 2.0
// section 3.11).
template<typename Number> float load_number(unsigned char const* bytes, bool normalized)
{
    auto const value = static_cast<float>(load<Number>(bytes));
    if (!normalized)
        return value;
    return std::max(-1.0f, value / static_cast<float>(std::numeric_limits<Number>::max()));
}

using Loader = float (*)(unsigned char const*, bool);

Loader loader_of(int component_type)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return load_number<std::int8_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load_number<std::uint8_t>;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return load_number<std::int16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load_number<std::uint16_t>;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return [](unsigned char const* bytes, bool) { return load<float>(bytes); };
    default:
        return nullptr;
    }
}

} // namespace

template<std::size_t Components>
Result<std::vector<std::array<float, Components>>> read_accessor(tinygltf::Model const& model,
                                                                 int accessor)
{
    auto const elements = TRY(find_elements(model, accessor, static_cast<int>(Components)));
    auto const load_component = loader_of(elements.component_type);
    if (!load_component)
        return fail_at(accessor, "has the wrong type");
    auto const component_bytes = static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(elements.component_type)));
    std::vector<std::array<float, Components>> values(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i)
        for (std::size_t k = 0; k < Components; ++k)
            values[i][k] = load_component(
                elements.first + i * elements.stride + k * component_bytes, elements.normalized);
    return values;
}

template Result<std::vector<std::array<float, 2>>> read_accessor<2>(tinygltf::Model const&, int);
template Result<std::vector<std::array<float, 3>>> read_accessor<3>(tinygltf::Model const&, int);
template Result<std::vector<std::array<float, 4>>> read_accessor<4>(tinygltf::Model const&, int);

Result<BulkVector<std::uint32_t>> read_indices(tinygltf::Model const& model, int accessor,
                                               std::size_t vertex_count)
{
    auto const elements = TRY(find_elements(model, accessor, 1));
    BulkVector<std::uint32_t> indices(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
        auto const* const bytes = elements.first + i * elements.stride;
        switch (elements.component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            indices[i] = load<std::uint8_t>(bytes);
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            indices[i] = load<std::uint16_t>(bytes);
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            indices[i] = load<std::uint32_t>(bytes);
            break;
        default:
            return fail_at(accessor, "has the wrong type");
        }
        if (indices[i] >= vertex_count)
            return fail_at(accessor, "names a vertex that does not exist");
    }
    return indices;
}

} // namespace tractus::exports
