#include "engine/export/bark_pictures.h"

#include "engine/export/bark_style.h"
#include "engine/export/gltf_material.h"
#include "engine/plant/png_pixels.h"

#include <cmath>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace tractus::exports {
namespace {

std::vector<Bark> all_barks()
{
    std::vector<Bark> barks;
    for (std::size_t kind = 1; kind < kBarkNames.size(); ++kind)
        for (auto const age : { BarkAge::Young, BarkAge::Half, BarkAge::Old })
            barks.push_back({ static_cast<BarkKind>(kind), age });
    return barks;
}

std::string name_of(Bark const& bark)
{
    return std::string(bark_name(bark.kind)) + " " + std::to_string(static_cast<int>(bark.age));
}

PixelRows pixels_of(TextureSlot const& slot)
{
    PixelRows rows;
    auto const read = read_png_pixels(slot->bytes, 1 << 24, [&](int width, int height) {
        rows = { width, height,
                 std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height)) };
        return rows.rgba.data();
    });
    EXPECT_TRUE(read.has_value());
    return rows;
}

// Mean difference of the pixels of two columns, or two rows.
double difference(PixelRows const& rows, int from, int to, bool are_columns)
{
    double sum = 0;
    for (int i = 0; i < rows.width; ++i)
        for (int k = 0; k < 3; ++k) {
            auto const level = [&](int place) {
                int const column = are_columns ? place : i;
                int const row = are_columns ? i : place;
                return static_cast<double>(
                    rows.rgba[static_cast<std::size_t>(4 * (row * rows.width + column) + k)]);
            };
            sum += std::abs(level(from) - level(to));
        }
    return sum / (3 * rows.width);
}

TEST(BarkPictures, CanBeTiledInBothDirections)
{
    constexpr int kSide = 64;
    for (auto const& bark : all_barks()) {
        auto const& made = bark_pictures(bark, kSide);
        for (auto const& slot : { made.color, made.normals, made.occlusion_roughness }) {
            EXPECT_EQ(slot->edges, TexturePicture::Edges::Repeat);
            auto const rows = pixels_of(slot);
            ASSERT_EQ(rows.width, kSide);
            ASSERT_EQ(rows.height, kSide);
            for (bool const are_columns : { false, true }) {
                double greatest = 0;
                for (int i = 0; i + 1 < kSide; ++i)
                    greatest = std::max(greatest, difference(rows, i, i + 1, are_columns));
                EXPECT_LE(difference(rows, kSide - 1, 0, are_columns), greatest + 1)
                    << name_of(bark);
            }
        }
    }
}

TEST(BarkPictures, HaveTheColourThatMaterialsAreGiven)
{
    for (auto const& bark : all_barks()) {
        auto const& made = bark_pictures(bark, 128);
        auto const told = bark_color(bark);
        // Where the bark is half old, the shares of both are by chance.
        double const tolerance = bark.age == BarkAge::Half ? 0.08 : 0.02;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(srgb_from_linear(made.mean_color[k]), double { told[k] }, tolerance)
                << name_of(bark);
    }
}

// Ratio of how much the colour changes around the branch and along it.
double change_around(Bark const& bark)
{
    auto const rows = pixels_of(bark_pictures(bark, 256).color);
    double around = 0;
    double along = 0;
    for (int i = 0; i + 1 < rows.width; ++i) {
        around += difference(rows, i, i + 1, true);
        along += difference(rows, i, i + 1, false);
    }
    return around / along;
}

TEST(BarkPictures, HaveFurrowsAlongTheTrunkOrLinesAroundIt)
{
    for (auto const kind : { BarkKind::Ash, BarkKind::Lime, BarkKind::Oak, BarkKind::Poplar,
                             BarkKind::Willow, BarkKind::Maple })
        EXPECT_GT(change_around({ kind, BarkAge::Old }), 1.15) << bark_name(kind);
    for (auto const kind : { BarkKind::Birch, BarkKind::Cherry, BarkKind::Beech })
        EXPECT_LT(change_around({ kind, BarkAge::Young }), 0.7) << bark_name(kind);
}

TEST(BarkPictures, BecomeRougherWithAge)
{
    for (auto const kind : { BarkKind::Ash, BarkKind::Birch, BarkKind::Oak, BarkKind::Pine,
                             BarkKind::Poplar, BarkKind::Willow })
        EXPECT_GT(bark_style(kind, BarkAge::Old).depth, 3 * bark_style(kind, BarkAge::Young).depth)
            << bark_name(kind);
    EXPECT_LT(bark_style(BarkKind::Beech, BarkAge::Old).depth, 0.01);
}

TEST(BarkPictures, AreTheSameForAllThreads)
{
    Bark const bark { BarkKind::Larch, BarkAge::Half };
    std::vector<BarkPictures const*> found(4);
    std::vector<std::thread> threads;
    for (auto& slot : found)
        threads.emplace_back([&] { slot = &bark_pictures(bark, 48); });
    for (auto& thread : threads)
        thread.join();
    for (auto const* pictures : found)
        EXPECT_EQ(pictures, found.front());
}

TEST(Bark, AgesAreInOrderOfTheGirth)
{
    for (std::size_t i = 0; i < kBarkNames.size(); ++i) {
        auto const kind = static_cast<BarkKind>(i);
        EXPECT_EQ(bark_kind(bark_name(kind)), kind);
        auto before = BarkAge::Young;
        for (double diameter_mm = 5; diameter_mm < 600; diameter_mm += 5) {
            auto const age = bark_age(kind, diameter_mm);
            EXPECT_GE(age, before);
            before = age;
        }
        EXPECT_EQ(bark_age(kind, 5), BarkAge::Young);
        EXPECT_EQ(before, BarkAge::Old);
    }
    EXPECT_FALSE(bark_kind("baobab"));
}

} // namespace
} // namespace tractus::exports
