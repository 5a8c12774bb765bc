#include "engine/methods/leaves/leaf_paint.h"
#include "tests/corpus.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <string>

namespace tractus::leaf {
namespace {

// A leaf of the shipped grammar "feather" and what is painted of it.
class LeafPaint : public ::testing::Test {
protected:
    void SetUp() override
    {
        std::ifstream file(shipped("leaves") / "feather.leaf");
        auto grammar
            = parse_grammar(std::string { std::istreambuf_iterator<char>(file), {} }, "feather");
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
    for (std::size_t i = 0; i < young.age.size(); ++i) {
        EXPECT_EQ(young.age[i], 0);
        EXPECT_EQ(old.age[i], 1);
    }
}

TEST_F(LeafPaint, GrowsNeverYoungerAnywhere)
{
    auto before = paint({ .side = 64, .age = 0 }).age;
    for (int i = 1; i <= 20; ++i) {
        auto const now = paint({ .side = 64, .age = i / 20.0 }).age;
        for (std::size_t pixel = 0; pixel < now.size(); ++pixel)
            ASSERT_GE(now[pixel], before[pixel]);
        before = now;
    }
}

TEST_F(LeafPaint, IsOlderNearerToVeins)
{
    auto const picture = paint({ .side = 128, .age = 0.5, .noise = 0 });
    std::vector<std::size_t> order(picture.age.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return picture.closeness[i]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        ASSERT_LE(picture.age[order[i]], picture.age[order[i - 1]]);
    EXPECT_LT(picture.age[order.back()], picture.age[order.front()]);
}

// The law looked at from its other end: what is old there is young here.
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

} // namespace
} // namespace tractus::leaf
