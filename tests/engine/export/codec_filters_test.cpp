#include "engine/export/codec_filters.h"

#include "engine/base/random.h"
#include "engine/export/attribute_codec.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/mesh_codec.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tractus::exports {
namespace {

// Returns the numbers that a reader decodes from filtered numbers.
template<typename Number>
std::vector<Number> read_back(std::span<Number const> filtered, CodecFilter filter,
                              std::size_t stride)
{
    auto const bytes = std::as_bytes(filtered);
    BulkVector<std::byte> compressed;
    compress_attributes(bytes, stride, compressed);
    std::vector<Number> back(filtered.size());
    EXPECT_TRUE(decompress(
        { .filter = filter, .count = bytes.size() / stride, .stride = stride, .bytes = compressed },
        std::as_writable_bytes(std::span(back))));
    return back;
}

std::vector<Vec3f> directions()
{
    Random random({ .seed = 1 });
    std::vector<Vec3f> all { Vec3f::UnitX(),  Vec3f::UnitY(),  Vec3f::UnitZ(),
                             -Vec3f::UnitX(), -Vec3f::UnitY(), -Vec3f::UnitZ() };
    for (int i = 0; i < 10001; ++i)
        all.push_back(
            Vec3(random.normal(), random.normal(), random.normal()).normalized().cast<float>());
    return all;
}

float worst_angle_deg(std::span<Vec3f const> expected, std::span<std::int8_t const> bytes)
{
    float worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        Vec3f const read = Vec3f(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2]).normalized();
        float const cosine = std::min(1.0f, read.dot(turn_to_gltf(expected[i])));
        worst = std::max(worst, std::acos(cosine) * 180 / static_cast<float>(kPi));
    }
    return worst;
}

TEST(CodecFilters, KeepDirections)
{
    auto const vectors = directions();
    std::vector<std::int8_t> filtered(4 * vectors.size());
    encode_octahedral(vectors, filtered.data());
    auto const back = read_back<std::int8_t>(filtered, CodecFilter::Octahedral, 4);
    EXPECT_LT(worst_angle_deg(vectors, back), 1.3f);
}

TEST(CodecFilters, KeepTangentsAndTheirSigns)
{
    auto const vectors = directions();
    std::vector<Eigen::Vector4f> tangents;
    for (std::size_t i = 0; i < vectors.size(); ++i)
        tangents.emplace_back(vectors[i].x(), vectors[i].y(), vectors[i].z(), i % 3 == 0 ? -1 : 1);
    std::vector<std::int8_t> filtered(4 * vectors.size());
    encode_octahedral(tangents, filtered.data());
    auto const back = read_back<std::int8_t>(filtered, CodecFilter::Octahedral, 4);
    EXPECT_LT(worst_angle_deg(vectors, back), 1.3f);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        EXPECT_EQ(back[4 * i + 3], i % 3 == 0 ? -127 : 127);
}

void expect_kept(float largest, float tolerance)
{
    Random random({ .seed = 2 });
    std::vector<float> values { 0, largest, -largest };
    for (int i = 0; i < 1000; ++i)
        values.push_back(static_cast<float>(random.uniform(-largest, largest)));
    std::vector<std::uint32_t> filtered(values.size());
    encode_exponential(values, filtered.data());
    auto const back = read_back<std::uint32_t>(filtered, CodecFilter::Exponential, 4);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(std::bit_cast<float>(back[i]), values[i], tolerance);
}

TEST(CodecFilters, KeepNumbersToAFewThousandths)
{
    expect_kept(1, 0.5f / 4096);
    expect_kept(1000, 0.5f / 4096);
    expect_kept(1e6f, 1e6f / 0x1p20f);
    expect_kept(1e30f, 1e30f / 0x1p20f);
}

TEST(CodecFilters, GiveSomeNumberForWhatIsNone)
{
    std::vector<float> const values { std::numeric_limits<float>::quiet_NaN(),
                                      std::numeric_limits<float>::infinity(), 1 };
    std::vector<std::uint32_t> filtered(values.size());
    encode_exponential(values, filtered.data());
    for (auto const word : read_back<std::uint32_t>(filtered, CodecFilter::Exponential, 4))
        EXPECT_TRUE(std::isfinite(std::bit_cast<float>(word)));
}

TEST(CodecFilters, TakeNothing)
{
    encode_octahedral(std::span<Vec3f const>(), nullptr);
    encode_exponential({}, nullptr);
}

} // namespace
} // namespace tractus::exports
