#include "engine/export/mesh_codec.h"

#include "engine/base/check.h"

#include <meshoptimizer.h>

namespace tractus::exports {
namespace {

// Maximum ratio of decompressed to compressed size: 256 equal bytes take at least four bytes, for
// headers.
constexpr std::uint64_t kMaxExpansion = 64;
constexpr std::uint64_t kMaxStride = 256;

// Sets the version of the encoding that the extension uses, since the library's default may change.
// Does so once, before the first compression, as the library stores the version without a lock.
void choose_version()
{
    [[maybe_unused]] static bool const is_chosen = [] {
        meshopt_encodeIndexVersion(1);
        return true;
    }();
}

char const* flaw_in_attributes(CompressedElements const& elements)
{
    auto const stride = elements.stride;
    if (stride == 0 || stride % 4 != 0 || stride > kMaxStride)
        return "has an impossible stride";
    if (elements.count > kMaxExpansion * elements.bytes.size() / stride)
        return "claims more elements than it can hold";
    bool const fits_filter = elements.filter == CodecFilter::Octahedral
        ? stride == 4 || stride == 8
        : elements.filter != CodecFilter::Quaternion || stride == 8;
    return fits_filter ? nullptr : "has a filter that does not fit its stride";
}

char const* flaw_in_indices(CompressedElements const& elements)
{
    if (elements.stride != 2 && elements.stride != 4)
        return "has an impossible stride";
    if (elements.filter != CodecFilter::None)
        return "has a filter, which indices cannot have";
    bool const are_triangles = elements.mode == CodecMode::Triangles;
    if (are_triangles && elements.count % 3 != 0)
        return "holds a part of a triangle";
    // An index, or in mode TRIANGLES a triangle, takes at least one byte.
    if (elements.count / (are_triangles ? 3 : 1) > elements.bytes.size())
        return "claims more elements than it can hold";
    return nullptr;
}

void undo_filter(CodecFilter filter, std::size_t count, std::size_t stride,
                 std::span<std::byte> elements)
{
    switch (filter) {
    case CodecFilter::None:
        break;
    case CodecFilter::Octahedral:
        return meshopt_decodeFilterOct(elements.data(), count, stride);
    case CodecFilter::Quaternion:
        return meshopt_decodeFilterQuat(elements.data(), count, stride);
    case CodecFilter::Exponential:
        return meshopt_decodeFilterExp(elements.data(), count, stride);
    }
}

} // namespace

void compress_indices(std::span<std::uint32_t const> indices, BulkVector<std::byte>& to)
{
    choose_version();
    to.resize(meshopt_encodeIndexSequenceBound(indices.size(), UINT32_MAX));
    auto const size = meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(to.data()),
                                                  to.size(), indices.data(), indices.size());
    CHECK(size > 0);
    to.resize(size);
}

char const* find_flaw(CompressedElements const& elements)
{
    if (elements.count == 0)
        return "has no elements";
    return elements.mode == CodecMode::Attributes ? flaw_in_attributes(elements)
                                                  : flaw_in_indices(elements);
}

bool decompress(CompressedElements const& elements, std::span<std::byte> to)
{
    CHECK(!find_flaw(elements) && to.size() == elements.count * elements.stride);
    auto const* const bytes = reinterpret_cast<unsigned char const*>(elements.bytes.data());
    auto const size = elements.bytes.size();
    if (elements.mode == CodecMode::Triangles)
        return meshopt_decodeIndexBuffer(to.data(), elements.count, elements.stride, bytes, size)
            == 0;
    if (elements.mode == CodecMode::Indices)
        return meshopt_decodeIndexSequence(to.data(), elements.count, elements.stride, bytes, size)
            == 0;
    if (meshopt_decodeVertexBuffer(to.data(), elements.count, elements.stride, bytes, size) != 0)
        return false;
    undo_filter(elements.filter, elements.count, elements.stride, to);
    return true;
}

} // namespace tractus::exports
