#include "tests/engine/methods/silhouettes/outlines.h"

#include "engine/methods/silhouettes/loops.h"

namespace tractus::silhouette {
namespace {

TEST(SilhouetteOutline, TakesEqualStepsCounterClockwise)
{
    auto drawing = ellipse(45, 90);
    std::reverse(drawing.outline[0].begin(), drawing.outline[0].end());
    auto const clean = cleaned(drawing);
    ASSERT_EQ(clean.outline.size(), 256U);
    EXPECT_GT(signed_area(clean.outline), 0);
    double const step = (clean.outline[1] - clean.outline[0]).norm();
    for (std::size_t i = 1; i < 256; ++i)
        EXPECT_NEAR((clean.outline[(i + 1) % 256] - clean.outline[i]).norm(), step, 0.02 * step);
    double const unit_mm = clean.to_sheet.turn.norm();
    EXPECT_NEAR(unit_mm, 2 * std::hypot(45, 90), 1e-9);
    EXPECT_NEAR(signed_area(clean.outline) * unit_mm * unit_mm, kPi * 45 * 90, 25);
    EXPECT_TRUE(clean.notes.empty());
}

TEST(SilhouetteOutline, PutsThePlaceBackOnTheSheet)
{
    auto const clean = cleaned(moved(star(5, 40, 100), { .to = Vec2(7, -30), .turn = Vec2(0, 2) }));
    auto const trunk = clean.to_sheet.points(clean.trunk);
    EXPECT_LT((trunk.front() - Vec2(87, -30)).norm(), 1e-4);
    EXPECT_LT((trunk.back() - Vec2(-53, -30)).norm(), 1e-4);
    EXPECT_NEAR(clean.trunk.front().norm(), 0, 1e-6);
    EXPECT_NEAR(clean.trunk.back().x(), 0, 1e-6);
}

TEST(SilhouetteOutline, ClosesASmallGapAndRefusesAWideOne)
{
    auto drawing = ellipse(60, 60);
    drawing.outline[0].resize(165); // The gap in the outline is 0.19 of the drawn length.
    EXPECT_EQ(cleaned(drawing).outline.size(), 256U);
    drawing.outline[0].resize(120);
    EXPECT_EQ(refusal(drawing), "the outline is open: end it near its beginning");
}

TEST(SilhouetteOutline, CutsOffWhatSticksOutAtTheEnds)
{
    Drawing drawing { { {} }, upright(-80, 40) };
    for (int i = -6; i <= 206; ++i) // The line is a spiral that continues beyond its beginning.
        drawing.outline[0].push_back((60 + 0.05 * i)
                                     * Vec2(std::cos(i * kPi / 100), std::sin(i * kPi / 100)));
    drawing.outline[0].insert(drawing.outline[0].begin(), Vec2(90, -30));
    auto const trimmed = without_overshoot(drawing.outline[0]);
    EXPECT_LT(trimmed.size(), drawing.outline[0].size());
    EXPECT_FALSE(crosses_itself(cleaned(drawing).outline));
}

TEST(SilhouetteOutline, KeepsTheLargestLoopAndSaysSo)
{
    Drawing eight { { {} }, {} };
    for (int i = 0; i < 240; ++i) {
        double const t = i * kPi / 120;
        double const wide = std::sin(t) > 0 ? 1.5 : 1;
        eight.outline[0].emplace_back(wide * 70 * std::sin(t), 40 * std::sin(2 * t));
    }
    auto const clean = cleaned(eight);
    auto const sheet = clean.to_sheet.points(clean.outline);
    EXPECT_GT(box_of(sheet).low.x(), -1);
    EXPECT_GT(box_of(sheet).high.x(), 100);
    ASSERT_EQ(clean.notes.size(), 2U);
    EXPECT_EQ(clean.notes[0],
              "the outline crosses itself: its largest loop counts, 40 % of the "
              "area are left out");
}

TEST(SilhouetteOutline, RefusesWhatIsTooSmall)
{
    EXPECT_EQ(refusal(ellipse(2, 3)), "the outline encloses 18.8 mm²: draw it larger");
    EXPECT_EQ(refusal({ { { Vec2(0, 0), Vec2(50, 0), Vec2(50, 50) } }, {} }),
              "the outline has 3 points: draw it larger, with 8 or more");
    EXPECT_EQ(refusal({}), "the outline is missing: draw it around the crown");
    auto dot = ellipse(50, 50);
    dot.trunk = { Vec2(1, 2), Vec2(1, 2) };
    EXPECT_EQ(refusal(dot),
              "the trunk is only a dot: draw it from the foot upwards, or leave it out");
    auto far = ellipse(50, 50);
    far.outline[0][3].x() = std::nan("");
    EXPECT_EQ(refusal(far), "a number of the drawing is too large: give millimetres");
    EXPECT_EQ(refusal({ { std::vector<Vec2>(20'001, Vec2(1, 1)) }, {} }),
              "the drawing has 20001 points: give at most 20000");
}

TEST(SilhouetteOutline, TakesATrunkUnderTheMiddleWhereNoneIsDrawn)
{
    auto drawing = ellipse(45, 90);
    drawing.trunk.clear();
    auto const clean = cleaned(drawing);
    auto const trunk = clean.to_sheet.points(clean.trunk);
    EXPECT_LT((trunk.front() - Vec2(0, -90)).norm(), 0.5);
    EXPECT_LT((trunk.back() - Vec2(0, 63)).norm(), 0.5);
    EXPECT_EQ(clean.notes.size(), 1U);
}

TEST(SilhouetteOutline, JoinsStrokesWhoseEndsAreNear)
{
    auto const whole = ellipse(60, 60);
    auto const& all = whole.outline[0];
    Drawing const pieces { { { all.begin() + 70, all.begin() + 130 },
                             { all.rbegin(), all.rbegin() + 68 },
                             { all.begin(), all.begin() + 68 } },
                           whole.trunk };
    auto const clean = cleaned(pieces);
    double const unit_mm = clean.to_sheet.turn.norm();
    EXPECT_NEAR(signed_area(clean.outline) * unit_mm * unit_mm, kPi * 3600, 60);
    EXPECT_TRUE(clean.notes.empty());
    auto more = pieces;
    more.outline.push_back({ Vec2(300, 0), Vec2(310, 0), Vec2(320, 5) });
    EXPECT_EQ(cleaned(more).notes.size(), 1U);
}

} // namespace
} // namespace tractus::silhouette
