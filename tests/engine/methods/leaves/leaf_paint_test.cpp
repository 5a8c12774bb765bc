#include "engine/methods/leaves/leaf_paint.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <string>

namespace tractus::leaf {
namespace {

// Fixture with a leaf of the grammar "feather" in the test data, and its picture.
class LeafPaint : public ::testing::Test {
protected:
    void SetUp() override
    {
        auto grammar = parse_grammar(file_bytes(shipped("leaves") / "feather.leaf"), "feather");
        ASSERT_TRUE(grammar.has_value());
        grammar_ = *std::move(grammar);
        auto leaf = Leaf::begin(grammar_, { .final_step = 6 });
        for (int i = 0; i < 6; ++i)
            ASSERT_TRUE(leaf->derive().has_value());
        ASSERT_TRUE(leaf->fill().has_value());
        leaf_ = *std::move(leaf);
        triangles_ = triangles_of(*leaf_);
    }

    LeafPicture paint(PaintOptions const& options) const
    {
        return paint_leaf(*leaf_, triangles_, options);
    }

    // Returns the indices of the pixels of the leaf, including those at its edge.
    static std::vector<std::size_t> pixels_of(LeafPicture const& picture)
    {
        std::vector<std::size_t> made;
        for (std::size_t i = 0; i < picture.coverage.size(); ++i)
            if (picture.coverage[i] > 0)
                made.push_back(i);
        return made;
    }

    Grammar grammar_;
    std::optional<Leaf> leaf_;
    LeafTriangles triangles_;
};

TEST_F(LeafPaint, CoversTheLeafsArea)
{
    auto const picture = paint({ .side = 256 });
    double const scale = PictureFrame(triangles_, 256).scale;
    double area = 0;
    for (auto const* const part : { &triangles_.veins, &triangles_.limb })
        for (auto const& [a, b, c] : *part) {
            Vec2 const u = triangles_.flat[b] - triangles_.flat[a];
            Vec2 const v = triangles_.flat[c] - triangles_.flat[a];
            area += 0.5 * std::abs(u.x() * v.y() - u.y() * v.x()) * scale * scale;
        }
    double covered = 0;
    for (auto const pixel : picture.coverage)
        covered += double(pixel);
    EXPECT_NEAR(covered / area, 1, 1e-4);
}

TEST_F(LeafPaint, MeasuresTheDistanceFromVeins)
{
    constexpr int kSide = 96;
    auto const picture = paint({ .side = kSide });
    PictureFrame const frame(triangles_, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (picture.coverage[static_cast<std::size_t>(y * kSide + x)] == 0)
                continue;
            double wanted = double(picture.reach);
            for (auto const& vein : leaf_->veins()) {
                Vec2 const from = frame.pixel(vein.from);
                Vec2 const side = frame.pixel(vein.to) - from;
                Vec2 const at(x + 0.5, y + 0.5);
                double const t = std::clamp((at - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
                double const half
                    = std::lerp(vein.half_width_from, vein.half_width_to, t) * frame.scale;
                wanted = std::min(wanted, std::max(0.0, (at - from - t * side).norm() - half));
            }
            EXPECT_NEAR(double(picture.distance[static_cast<std::size_t>(y * kSide + x)]), wanted,
                        0.01);
        }
}

TEST_F(LeafPaint, IsAllYoungAtFirstAndAllOldAtLast)
{
    auto const young = paint({ .side = 64, .age = 0 });
    auto const old = paint({ .side = 64, .age = 1 });
    for (auto const i : pixels_of(young)) {
        EXPECT_EQ(young.age[i], 0);
        EXPECT_EQ(old.age[i], 1);
    }
}

TEST_F(LeafPaint, GrowsNeverYoungerAnywhere)
{
    auto before = paint({ .side = 64, .age = 0 });
    for (int i = 1; i <= 20; ++i) {
        auto const now = paint({ .side = 64, .age = i / 20.0 });
        for (auto const pixel : pixels_of(now))
            ASSERT_GE(now.age[pixel], before.age[pixel]);
        before = now;
    }
}

TEST_F(LeafPaint, IsOlderNearerToVeins)
{
    auto const picture = paint({ .side = 128, .age = 0.5, .noise = 0 });
    auto order = pixels_of(picture);
    std::ranges::sort(order, {}, [&](std::size_t i) { return picture.closeness[i]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        ASSERT_LE(picture.age[order[i]], picture.age[order[i - 1]]);
    EXPECT_LT(picture.age[order.back()], picture.age[order.front()]);
}

// If the age of the leaf, the closeness to veins and the noise are all reversed, the age of a point
// must be reversed, too, as if the colours for old and young leaves were exchanged.
TEST_F(LeafPaint, TurnsRoundWithItsColors)
{
    PaintOptions const options;
    for (double const age : { 0.0, 0.2, 0.5, 0.9, 1.0 })
        for (double const closeness : { 0.0, 0.3, 1.0 })
            for (double const noise : { 0.0, 0.7, 1.0 })
                EXPECT_NEAR(age_at(age, closeness, noise, options),
                            1 - age_at(1 - age, 1 - closeness, 1 - noise, options), 1e-12);
}

TEST_F(LeafPaint, LetsLarvaeEatNoSparedVein)
{
    auto const whole = paint({ .side = 256 });
    auto const eaten = paint({ .side = 256, .larvae = { .count = 8 } });
    double lost = 0;
    for (std::size_t i = 0; i < whole.alpha.size(); ++i) {
        EXPECT_LE(eaten.alpha[i], whole.alpha[i]);
        lost += double(whole.alpha[i] - eaten.alpha[i]);
        if (eaten.protection[i] == 1) {
            EXPECT_EQ(eaten.alpha[i], whole.alpha[i]);
        }
    }
    EXPECT_GT(lost, 100);
}

TEST_F(LeafPaint, LosesMoreToMoreLarvae)
{
    auto before = paint({ .side = 128 });
    for (int count = 1; count <= 6; ++count) {
        auto const now = paint({ .side = 128, .larvae = { .count = count } });
        for (std::size_t i = 0; i < now.alpha.size(); ++i)
            ASSERT_LE(now.alpha[i], before.alpha[i]);
        before = now;
    }
}

TEST_F(LeafPaint, KeepsWhatHangsTogether)
{
    constexpr int kSide = 160;
    auto const picture = paint({ .side = kSide, .larvae = { .count = 12 } });
    std::vector<int> group(picture.alpha.size(), -1);
    int groups = 0;
    for (std::size_t start = 0; start < group.size(); ++start) {
        if (group[start] >= 0 || picture.alpha[start] <= 0)
            continue;
        std::vector<std::size_t> pending { start };
        group[start] = groups;
        while (!pending.empty()) {
            auto const i = pending.back();
            pending.pop_back();
            auto const visit = [&](std::size_t next) {
                if (next < group.size() && group[next] < 0 && picture.alpha[next] > 0) {
                    group[next] = groups;
                    pending.push_back(next);
                }
            };
            visit(i + 1);
            visit(i - 1);
            visit(i + kSide);
            visit(i - kSide);
        }
        ++groups;
    }
    EXPECT_EQ(groups, 1);
}

TEST_F(LeafPaint, LeavesVeinsOfASkeleton)
{
    auto const whole = paint({ .side = 256 });
    auto const bones = paint({ .side = 256, .is_skeleton = true });
    double left = 0;
    double all = 0;
    for (std::size_t i = 0; i < whole.alpha.size(); ++i) {
        left += double(bones.alpha[i]);
        all += double(whole.alpha[i]);
        if (bones.distance[i] > 6) {
            EXPECT_EQ(bones.alpha[i], 0);
        }
    }
    EXPECT_LT(left, 0.6 * all);
    EXPECT_GT(left, 0.02 * all);
}

TEST_F(LeafPaint, HasNormalsOfLengthOne)
{
    for (auto const& [x, y, z] : paint({ .side = 128 }).normal) {
        Vec3 const n = Vec3(x, y, z) / 127.5 - Vec3::Ones();
        EXPECT_NEAR(n.norm(), 1, 0.02);
        EXPECT_GT(n.z(), 0);
    }
}

TEST_F(LeafPaint, IsTheSameAgain)
{
    PaintOptions const options { .side = 128, .age = 0.6, .spots = 0.4, .larvae = { .count = 3 } };
    auto const once = paint(options);
    auto const again = paint(options);
    EXPECT_EQ(once.color, again.color);
    EXPECT_EQ(once.normal, again.normal);
    EXPECT_EQ(once.roughness, again.roughness);
    EXPECT_EQ(once.translucency, again.translucency);
}

// The picture must depend neither on what the painter has painted before, nor on the size of the
// earlier pictures.
TEST_F(LeafPaint, IsTheSameFromAPainterThatHasPaintedBefore)
{
    PaintOptions const options {
        .side = 100, .age = 0.6, .spots = 0.4, .mildew = 0.5, .mines = 2, .larvae = { .count = 3 }
    };
    auto const fresh = paint(options);
    LeafPainter painter;
    painter.paint(*leaf_, triangles_,
                  { .side = 160, .spots = 1, .larvae = { .count = 9 }, .is_skeleton = true });
    auto const& used = painter.paint(*leaf_, triangles_, options);
    EXPECT_EQ(fresh.color, used.color);
    EXPECT_EQ(fresh.normal, used.normal);
    EXPECT_EQ(fresh.roughness, used.roughness);
    EXPECT_EQ(fresh.translucency, used.translucency);
}

// When pictures are reduced, only the leaf's own colours may mix. So no pixel outside of the leaf
// may be darker than the whole leaf.
TEST_F(LeafPaint, GoesOnInItsColorsOutside)
{
    auto const picture = paint({ .side = 128 });
    std::array<int, 3> darkest { 255, 255, 255 };
    for (std::size_t i = 0; i < picture.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (picture.coverage[i] > 0)
                darkest[c] = std::min<int>(darkest[c], picture.color[i][c]);
    for (std::size_t i = 0; i < picture.color.size(); ++i) {
        if (picture.coverage[i] > 0)
            continue;
        EXPECT_EQ(picture.color[i][3], 0);
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_GE(picture.color[i][c], darkest[c] - 12);
        ASSERT_GT(picture.normal[i][2], 128);
        ASSERT_GT(picture.roughness[i][1], 80);
    }
}

TEST_F(LeafPaint, IsOlderBetweenVeinsWhereThatGrowsOldFirst)
{
    auto const picture = paint(
        { .side = 128, .age = 0.5, .first = PaintOptions::First::BetweenVeins, .noise = 0 });
    auto order = pixels_of(picture);
    std::ranges::sort(order, {}, [&](std::size_t i) { return picture.closeness[i]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        ASSERT_GE(picture.age[order[i]], picture.age[order[i - 1]]);
    EXPECT_GT(picture.age[order.back()], picture.age[order.front()]);
}

TEST_F(LeafPaint, GrowsOldFromItsTip)
{
    auto const picture = paint({ .side = 128, .age = 0.5, .near_veins = 0, .tip = 1 });
    float before = 1;
    for (std::size_t y = 0; y < 128; ++y)
        for (std::size_t x = 0; x < 128; ++x)
            if (auto const i = y * 128 + x; picture.coverage[i] > 0) {
                ASSERT_LE(picture.age[i], before);
                before = picture.age[i];
            }
    EXPECT_LT(before, 0.5f);
}

// At the end of its life, the leaf must have the third colour everywhere, whatever the first two
// colours are.
TEST_F(LeafPaint, DiesAtLast)
{
    auto const one
        = paint({ .side = 64, .age = 1, .young = { 0, 1, 0 }, .old = { 1, 1, 0 }, .dead_age = 1 });
    auto const other
        = paint({ .side = 64, .age = 1, .young = { 1, 0, 0 }, .old = { 0, 0, 1 }, .dead_age = 1 });
    EXPECT_EQ(one.color, other.color);
    EXPECT_NE(one.color, paint({ .side = 64, .age = 1 }).color);
}

// Compares the normals with the slopes of the relief. Seen from below, ridges become grooves.
TEST_F(LeafPaint, HasTheNormalsOfItsRelief)
{
    constexpr std::size_t kSide = 128;
    auto const picture = paint({ .side = kSide });
    double worst = 0;
    for (std::size_t y = 1; y + 1 < kSide; ++y)
        for (std::size_t x = 1; x + 1 < kSide; ++x) {
            auto const i = y * kSide + x;
            if (picture.coverage[i] == 0)
                continue;
            double const du = double(picture.height[i + 1] - picture.height[i - 1]) / 2;
            double const dv = double(picture.height[i - kSide] - picture.height[i + kSide]) / 2;
            Vec3 const wanted = Vec3(-0.006 * kSide * du, -0.006 * kSide * dv, 1).normalized();
            auto const& [r, g, b] = picture.normal[i];
            worst = std::max(worst, (Vec3(r, g, b) / 127.5 - Vec3::Ones() - wanted).norm());
        }
    EXPECT_LT(worst, 0.01);
}

TEST_F(LeafPaint, IsMinedBesideItsVeins)
{
    auto const whole = paint({ .side = 256 });
    auto const mined = paint({ .side = 256, .mines = 4 });
    std::size_t changed = 0;
    for (std::size_t i = 0; i < whole.color.size(); ++i) {
        bool const is_other = whole.color[i] != mined.color[i] && whole.coverage[i] > 0;
        changed += is_other;
        if (whole.protection[i] == 1 && whole.distance[i] == 0) {
            EXPECT_FALSE(is_other);
        }
    }
    EXPECT_GT(changed, 200u);
    EXPECT_EQ(whole.alpha, mined.alpha);
}

// Without veins, each larva eats a disc with one bite. Overlapping discs must give their union.
TEST(LeafLarvae, EatTheUnionOfTheirDiscs)
{
    constexpr int kSide = 200;
    std::vector<float> coverage(kSide * kSide, 0);
    auto const is_edge = [](int x, int y) { return std::min({ x, y, 199 - x, 199 - y }) == 20; };
    for (int y = 20; y < kSide - 20; ++y)
        for (int x = 20; x < kSide - 20; ++x)
            coverage[static_cast<std::size_t>(y * kSide + x)] = 1;
    std::vector<float> const protection(kSide * kSide, 0);
    LarvaGround const ground { kSide, coverage, protection };
    Larvae const larvae {
        .count = 1, .min_radius = 0.03, .most_radius = 0.03, .min_bites = 1, .most_bites = 1
    };
    double const radius = 0.03 * kSide;
    int whole = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        std::vector<float> alpha = coverage;
        std::vector<float> eaten(alpha.size());
        eat(ground, larvae, seed, alpha, eaten);
        double area = 0;
        bool is_inside = true;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                auto const i = static_cast<std::size_t>(y * kSide + x);
                area += double(coverage[i] - alpha[i]);
                is_inside &= !is_edge(x, y) || alpha[i] == 1;
            }
        whole += is_inside;
        if (is_inside) {
            EXPECT_NEAR(area / (kPi * radius * radius), 1, 0.1);
        }
    }
    EXPECT_GT(whole, 5) << "some begin inside";
}

} // namespace
} // namespace tractus::leaf
