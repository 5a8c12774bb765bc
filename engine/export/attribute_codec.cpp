#include "engine/export/attribute_codec.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

// Data layout of EXT_meshopt_compression, appendix A, mode 0. Elements are divided into blocks. A
// block has the first bytes of all its elements, then all second bytes, and so on. Each byte is
// stored as the difference from that byte of the previous element, in groups of 16 differences with
// 0, 2, 4 or 8 bits each.

namespace tractus::exports {
namespace {

constexpr std::byte kVersion { 0xa0 };
constexpr std::size_t kGroup = 16;
constexpr std::size_t kBlockBytes = 8192;
constexpr std::size_t kMaxInBlock = 256;
constexpr std::size_t kMinTail = 32;
constexpr std::size_t kMaxElementBytes = 256;

using Sixteen = std::uint8_t __attribute__((vector_size(kGroup)));
using TwoWords = std::array<std::uint64_t, 2>;

Sixteen load_sixteen(std::uint8_t const* from)
{
    Sixteen bytes;
    std::memcpy(&bytes, from, sizeof bytes);
    return bytes;
}

// Zigzag encoding: maps 0, -1, 1, -2, 2, ... to 0, 1, 2, 3, 4, ...
Sixteen zigzag(Sixteen const& differences)
{
    Sixteen const negative = differences > 127 ? Sixteen {} + 255 : Sixteen {};
    return (differences + differences) ^ negative;
}

// Returns the number of values that are at least `least`.
std::size_t count_from(Sixteen const& values, int least)
{
    auto const ones = std::bit_cast<TwoWords>(
        values >= static_cast<std::uint8_t>(least) ? Sixteen {} + 1 : Sixteen {});
    return (ones[0] + ones[1]) * 0x0101010101010101 >> 56;
}

Sixteen at_most(Sixteen const& values, int most)
{
    auto const limit = Sixteen {} + static_cast<std::uint8_t>(most);
    return values < limit ? values : limit;
}

// Packs each value into 2 bits. Of four values in a byte the first one has the highest bits.
std::uint8_t* pack_two_bits(Sixteen const& values, std::uint8_t* to)
{
    for (auto const word : std::bit_cast<std::array<std::uint32_t, 4>>(values))
        *to++ = static_cast<std::uint8_t>(word * 0x40100401 >> 24);
    return to;
}

// Packs each value into 4 bits. Of two values in a byte the first one has the higher bits.
std::uint8_t* pack_four_bits(Sixteen const& values, std::uint8_t* to)
{
    for (auto const word : std::bit_cast<TwoWords>(values)) {
        auto pairs = (word << 4 | word >> 8) & 0x00FF00FF00FF00FF;
        pairs = (pairs | pairs >> 8) & 0x0000FFFF0000FFFF;
        auto const packed = static_cast<std::uint32_t>(pairs | pairs >> 16);
        std::memcpy(to, &packed, sizeof packed);
        to += sizeof packed;
    }
    return to;
}

// Appends, with 8 bits each, the values that are at least `least`, which do not fit into the 2 or 4
// bits of their group.
std::uint8_t* append_from(Sixteen const& values, int least, std::uint8_t* to)
{
    std::array<std::uint8_t, kGroup> all;
    std::memcpy(all.data(), &values, sizeof all);
    for (auto const value : all) {
        *to = value;
        to += value >= least ? 1 : 0;
    }
    return to;
}

// Appends a group in its smallest encoding, whose number is stored in `way`. May overwrite up to 15
// bytes beyond the returned end.
std::uint8_t* append_group(Sixteen const& values, unsigned& way, std::uint8_t* to)
{
    auto const words = std::bit_cast<TwoWords>(values);
    way = 0;
    if ((words[0] | words[1]) == 0)
        return to;
    auto const beyond_two = count_from(values, 3);
    auto const beyond_four = count_from(values, 15);
    if (4 + beyond_two <= 8 + beyond_four && 4 + beyond_two < kGroup) {
        way = 1;
        to = pack_two_bits(at_most(values, 3), to);
        return beyond_two > 0 ? append_from(values, 3, to) : to;
    }
    if (8 + beyond_four < kGroup) {
        way = 2;
        to = pack_four_bits(at_most(values, 15), to);
        return beyond_four > 0 ? append_from(values, 15, to) : to;
    }
    way = 3;
    std::memcpy(to, &values, kGroup);
    return to + kGroup;
}

// The same byte of every element of a block, preceded by that byte of the element before the block.
// The byte of the last element is repeated until the last group of 16 is full.
struct Column {
    std::array<std::uint8_t, 1 + kMaxInBlock> bytes;
};

Sixteen first_halves(Sixteen const& a, Sixteen const& b)
{
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}

Sixteen second_halves(Sixteen const& a, Sixteen const& b)
{
    return __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15,
                                   31);
}

// Transposes 16 words of four bytes to all first bytes, all second bytes, and so on, by four
// perfect shuffles of the 64 bytes.
void transpose(std::array<Sixteen, 4>& words)
{
    for (int i = 0; i < 4; ++i) {
        auto const [a, b, c, d] = words;
        words
            = { first_halves(a, c), second_halves(a, c), first_halves(b, d), second_halves(b, d) };
    }
}

// A block: `count` elements of `element_bytes` each, one after another from `first` on.
struct Block {
    std::uint8_t const* first = nullptr;
    std::size_t count = 0;
    std::size_t element_bytes = 0;

    std::size_t groups() const { return (count + kGroup - 1) / kGroup; }
};

// Fills four columns with bytes `k` to `k` + 3 of all elements of the block. The bytes of the
// element before the block are not set.
void fill_columns(Block const& block, std::size_t k, std::array<Column, 4>& columns)
{
    for (std::size_t group = 0; group < block.groups(); ++group) {
        std::array<std::uint32_t, kGroup> gathered;
        for (std::size_t i = 0; i < kGroup; ++i) {
            auto const element = std::min(group * kGroup + i, block.count - 1);
            std::memcpy(&gathered[i], block.first + element * block.element_bytes + k,
                        sizeof gathered[i]);
        }
        auto words = std::bit_cast<std::array<Sixteen, 4>>(gathered);
        transpose(words);
        for (std::size_t i = 0; i < 4; ++i)
            std::memcpy(columns[i].bytes.data() + 1 + group * kGroup, &words[i], kGroup);
    }
}

std::uint8_t* append_column(Column const& column, std::size_t groups, std::uint8_t* to)
{
    auto* const heads = to;
    auto const head_bytes = (groups + 3) / 4;
    std::fill_n(heads, head_bytes, std::uint8_t { 0 });
    to += head_bytes;
    for (std::size_t i = 0; i < groups; ++i) {
        auto const* const from = column.bytes.data() + i * kGroup;
        unsigned way = 0;
        to = append_group(zigzag(load_sixteen(from + 1) - load_sixteen(from)), way, to);
        heads[i / 4] = static_cast<std::uint8_t>(heads[i / 4] | way << (i % 4 * 2));
    }
    return to;
}

// Returns the maximum compressed size of `count` elements in blocks of `block` elements, including
// the bytes beyond the end that append_group() may overwrite.
std::size_t most_bytes(std::size_t count, std::size_t element_bytes, std::size_t block)
{
    auto const blocks = (count + block - 1) / block;
    auto const column = block + kGroup + block / (4 * kGroup) + 1;
    return 1 + blocks * element_bytes * column + std::max(element_bytes, kMinTail) + kGroup;
}

} // namespace

void compress_attributes(std::span<std::byte const> elements, std::size_t element_bytes,
                         BulkVector<std::byte>& to)
{
    CHECK(element_bytes > 0 && element_bytes % 4 == 0 && element_bytes <= kMaxElementBytes);
    auto const count = elements.size() / element_bytes;
    CHECK(count > 0);
    auto const most = std::min(kBlockBytes / element_bytes / kGroup * kGroup, kMaxInBlock);
    to.resize(most_bytes(count, element_bytes, most));
    to[0] = kVersion;
    auto* end = reinterpret_cast<std::uint8_t*>(to.data()) + 1;
    auto const* const from = reinterpret_cast<std::uint8_t const*>(elements.data());
    std::array<Column, 4> columns {};
    for (std::size_t first = 0; first < count; first += most) {
        Block const block { from + first * element_bytes, std::min(most, count - first),
                            element_bytes };
        auto const* const before = first > 0 ? block.first - element_bytes : from;
        for (std::size_t k = 0; k < element_bytes; ++k) {
            if (k % 4 == 0)
                fill_columns(block, k, columns);
            columns[k % 4].bytes[0] = before[k];
            end = append_column(columns[k % 4], block.groups(), end);
        }
    }
    // The tail of the stream is padding and then the first element, from which the decoder starts.
    auto const padding = element_bytes < kMinTail ? kMinTail - element_bytes : 0;
    end = std::fill_n(end, padding, std::uint8_t { 0 });
    end = std::copy_n(from, element_bytes, end);
    to.resize(static_cast<std::size_t>(end - reinterpret_cast<std::uint8_t*>(to.data())));
}

} // namespace tractus::exports
