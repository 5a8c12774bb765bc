#include "engine/export/mesh_codec.h"

#include "engine/export/attribute_codec.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

namespace tractus::exports {
namespace {

std::span<std::byte const> bytes_of(auto const& numbers)
{
    return std::as_bytes(std::span(numbers));
}

// Compresses elements of `words` words each, and expects that the library meshoptimizer
// decompresses them correctly.
void expect_back(std::vector<std::uint32_t> const& numbers, std::size_t words)
{
    BulkVector<std::byte> compressed;
    compress_attributes(bytes_of(numbers), 4 * words, compressed);
    CompressedElements const elements { .count = numbers.size() / words,
                                        .stride = 4 * words,
                                        .bytes = compressed };
    RC_ASSERT(find_flaw(elements) == nullptr);
    std::vector<std::uint32_t> back(numbers.size());
    RC_ASSERT(decompress(elements, std::as_writable_bytes(std::span(back))));
    RC_ASSERT(back == numbers);
}

RC_GTEST_PROP(MeshCodec, GivesAttributesBack, ())
{
    auto const words = *rc::gen::element<std::size_t>(1, 2, 3, 4);
    auto const count = *rc::gen::inRange<std::size_t>(1, 2000);
    auto const numbers = *rc::gen::container<std::vector<std::uint32_t>>(
        count * words, rc::gen::arbitrary<std::uint32_t>());
    expect_back(numbers, words);
}

// The differences between elements are random and of every size, so that groups of bytes are
// encoded in every way.
RC_GTEST_PROP(MeshCodec, GivesSmoothAttributesBack, ())
{
    auto const count = *rc::gen::inRange<std::size_t>(1, 1500);
    auto const words = *rc::gen::element<std::size_t>(1, 2, 3, 16, 64);
    auto const steepest = *rc::gen::element(1, 3, 10, 40, 300);
    auto const steps
        = *rc::gen::container<std::vector<int>>(64, rc::gen::inRange(-steepest, steepest + 1));
    std::vector<std::uint32_t> numbers(count * words);
    for (std::size_t i = words; i < numbers.size(); ++i)
        numbers[i] = numbers[i - words] + static_cast<std::uint32_t>(steps[i * 7 % steps.size()]);
    expect_back(numbers, words);
}

RC_GTEST_PROP(MeshCodec, GivesIndicesBackInEitherSize, ())
{
    auto const indices = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 65535)));
    BulkVector<std::byte> compressed;
    compress_indices(indices, compressed);
    CompressedElements elements {
        .mode = CodecMode::Indices, .count = indices.size(), .stride = 4, .bytes = compressed
    };
    RC_ASSERT(find_flaw(elements) == nullptr);
    std::vector<std::uint32_t> back(indices.size());
    RC_ASSERT(decompress(elements, std::as_writable_bytes(std::span(back))));
    RC_ASSERT(back == indices);
    elements.stride = 2;
    std::vector<std::uint16_t> short_back(indices.size());
    RC_ASSERT(decompress(elements, std::as_writable_bytes(std::span(short_back))));
    RC_ASSERT(std::equal(short_back.begin(), short_back.end(), indices.begin()));
}

TEST(MeshCodec, HoldsManyElementsThatAreAlike)
{
    std::vector<std::uint32_t> const numbers(100'000, 7);
    BulkVector<std::byte> compressed;
    compress_attributes(bytes_of(numbers), 4, compressed);
    EXPECT_EQ(find_flaw({ .count = numbers.size(), .stride = 4, .bytes = compressed }), nullptr);
}

// The first byte must contain the version of the format (EXT_meshopt_compression, appendix A).
TEST(MeshCodec, WritesTheVersionsOfTheExtension)
{
    std::vector<std::uint32_t> const numbers { 0, 1, 2 };
    BulkVector<std::byte> compressed;
    compress_attributes(bytes_of(numbers), 4, compressed);
    EXPECT_EQ(compressed.front(), std::byte { 0xa0 });
    compress_indices(numbers, compressed);
    EXPECT_EQ(compressed.front(), std::byte { 0xd1 });
}

RC_GTEST_PROP(MeshCodec, RefusesWhatIsTruncated, ())
{
    auto const numbers
        = *rc::gen::container<std::vector<std::uint32_t>>(600, rc::gen::arbitrary<std::uint32_t>());
    BulkVector<std::byte> compressed;
    compress_attributes(bytes_of(numbers), 8, compressed);
    compressed.resize(*rc::gen::inRange<std::size_t>(100, compressed.size()));
    CompressedElements const elements { .count = 300, .stride = 8, .bytes = compressed };
    std::vector<std::uint32_t> back(600);
    RC_ASSERT(!decompress(elements, std::as_writable_bytes(std::span(back))));
}

// Decompressing damaged bytes must fail or give arbitrary numbers, but never crash.
RC_GTEST_PROP(MeshCodec, SurvivesAnyBytes, ())
{
    auto const mode
        = *rc::gen::element(CodecMode::Attributes, CodecMode::Triangles, CodecMode::Indices);
    auto const bytes = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
    CompressedElements const elements { .mode = mode,
                                        .count = *rc::gen::inRange<std::uint64_t>(0, 300),
                                        .stride = *rc::gen::element<std::uint64_t>(2, 4, 8),
                                        .bytes = bytes_of(bytes) };
    if (find_flaw(elements))
        return;
    std::vector<std::byte> back(elements.count * elements.stride);
    (void)decompress(elements, back);
}

TEST(MeshCodec, SaysWhatCannotBe)
{
    std::vector<std::byte> const bytes(100);
    CompressedElements const good { .count = 100, .stride = 8, .bytes = bytes };
    EXPECT_EQ(find_flaw(good), nullptr);
    auto const is_flawed = [&](auto const& change) {
        auto elements = good;
        change(elements);
        return find_flaw(elements) != nullptr;
    };
    EXPECT_TRUE(is_flawed([](auto& e) { e.count = 0; }));
    EXPECT_TRUE(is_flawed([](auto& e) { e.count = 100 * 64 / 8 + 1; }));
    EXPECT_TRUE(is_flawed([](auto& e) { e.count = UINT64_MAX; }));
    EXPECT_TRUE(is_flawed([](auto& e) { e.stride = 0; }));
    EXPECT_TRUE(is_flawed([](auto& e) { e.stride = 6; }));
    EXPECT_TRUE(is_flawed([](auto& e) { e.stride = 260; }));
    EXPECT_TRUE(is_flawed([](auto& e) { e.mode = CodecMode::Indices; }));
    EXPECT_TRUE(is_flawed([](auto& e) {
        e.stride = 12;
        e.filter = CodecFilter::Octahedral;
    }));
    EXPECT_TRUE(is_flawed([](auto& e) {
        e.stride = 4;
        e.filter = CodecFilter::Quaternion;
    }));
    EXPECT_TRUE(is_flawed([](auto& e) {
        e.mode = CodecMode::Triangles;
        e.stride = 4;
    }));
}

} // namespace
} // namespace tractus::exports
