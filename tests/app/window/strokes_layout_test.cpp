#include "app/window/shortcuts.h"
#include "app/window/workspace.h"
#include "tests/app/window/layout_fixture.h"

#include <gtest/gtest.h>

namespace tractus::window {

using namespace layout_tests;

namespace {

// Adds curves that stand side by side and are as tall as the drawing volume.
void add_curves(DrawingModel& model, std::size_t count)
{
    std::vector<view::DrawnCurveView> curves;
    for (std::size_t i = 0; i < count; ++i) {
        view::DrawnCurveView curve { .edit = i + 1, .name = "Draw: branch 1 of stem 1" };
        float const x = (static_cast<float>(i) + 0.5f) / static_cast<float>(count) * 200 - 100;
        for (int k = 0; k <= 20; ++k)
            curve.line.points.push_back({ { x, 0, static_cast<float>(10 + 14 * k) }, 3 });
        curves.push_back(std::move(curve));
    }
    model.draw_curves(std::move(curves));
}

Workspace::Shown after_keys(std::size_t count)
{
    DrawingModel model;
    Workspace workspace;
    ToolRing ring;
    for (std::size_t i = 0; i < count; ++i)
        take_shortcut({ 'V' }, model, workspace, ring);
    return workspace.shown;
}

} // namespace

TEST(ShownViews, FollowEachOtherAndHaveWords)
{
    auto const words = shown_words();
    ASSERT_EQ(words.size(), 6u);
    for (std::size_t i = 0; i < words.size(); ++i)
        EXPECT_EQ(after_keys(i), parse_shown(words[i])) << words[i];
    EXPECT_EQ(after_keys(words.size()), Workspace::Shown::All);
    EXPECT_EQ(parse_shown("strokes"), Workspace::Shown::Strokes);
    EXPECT_FALSE(parse_shown("stroke"));
    EXPECT_FALSE(parse_shown(""));
}

TEST_F(LayoutTest, ShowsStrokesBelowThePadWhereThereIsRoom)
{
    std::size_t with_strokes = 0;
    for (auto const& size : sizes())
        for (std::size_t const count : { 0u, 3u, 1000u }) {
            // Other numbers of curves than 3 are tested with a single window size, at both scales.
            if (count != 3 && size.width != 1280)
                continue;
            SCOPED_TRACE(fmt::format("{}, {} curves", text_of(size), count));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout&, DrawingModel& model) { add_curves(model, count); },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    check_buttons(drawn, size_px);
                    for (std::size_t i = 0; i < drawn.pictures.size(); ++i)
                        for (std::size_t j = i + 1; j < drawn.pictures.size(); ++j)
                            EXPECT_FALSE(overlap(drawn.pictures[i], drawn.pictures[j]));
                    if (drawn.pictures.size() < 4)
                        return;
                    ++with_strokes;
                    auto const& pad = drawn.pictures[0];
                    auto const& strokes = drawn.pictures[1];
                    EXPECT_EQ(strokes.left, pad.left);
                    EXPECT_EQ(strokes.right, pad.right);
                    EXPECT_GE(strokes.top, pad.bottom);
                    EXPECT_GE(strokes.height(), 130 * size.scale);
                    EXPECT_GE(pad.height(), 0.75f * pad.width()) << "as deep as the tablet";
                });
        }
    EXPECT_GE(with_strokes, 4u);
}

TEST_F(LayoutTest, ShowsStrokesAloneBesideTheirList)
{
    for (auto const& size : sizes())
        for (bool const is_left_handed : { false, true }) {
            if (is_left_handed && size.width != 1280)
                continue;
            SCOPED_TRACE(fmt::format("{}, {}", text_of(size), is_left_handed));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout& layout, DrawingModel& model) {
                    add_curves(model, 1000);
                    layout.workspace().is_left_handed = is_left_handed;
                    layout.workspace().shown = Workspace::Shown::Strokes;
                },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    check_buttons(drawn, size_px);
                    ASSERT_EQ(drawn.pictures.size(), 1u);
                    auto const& picture = drawn.pictures.front();
                    bool const has_list = size.width >= 920;
                    float const list_px = has_list ? 460 * size.scale : 0;
                    EXPECT_NEAR(picture.left, is_left_handed ? 0 : list_px, 1);
                    EXPECT_NEAR(picture.right, is_left_handed ? size_px.x - list_px : size_px.x, 1);
                });
        }
}

// A click on a curve must pick it. A drag must turn the view and pick nothing.
TEST_F(LayoutTest, PicksTheClickedStroke)
{
    DrawingModel model;
    add_curves(model, 1);
    auto const at = [](float x, float y, bool is_down) { return Moment { { x, y }, is_down }; };
    auto const alone = [](Layout& layout) { layout.workspace().shown = Workspace::Shown::Strokes; };
    // The only curve is upright, in the middle of the picture. The clicks cross it.
    std::vector<Moment> clicks { at(5, 5, false) };
    for (float x = 640; x < 1100; x += 12)
        for (bool const is_down : { false, true, false })
            clicks.push_back(at(x, 300, is_down));
    work({ 1280, 720 }, clicks, model, alone);
    ASSERT_FALSE(model.picked.empty());
    EXPECT_LE(model.picked.size(), 4u) << "only near the curve";
    for (auto const curve : model.picked)
        EXPECT_EQ(curve, 0u);
    model.picked.clear();
    work({ 1280, 720 },
         { at(640, 300, false), at(640, 300, true), at(700, 310, true), at(860, 320, true),
           at(860, 320, false) },
         model, alone);
    EXPECT_TRUE(model.picked.empty());
}

TEST_F(LayoutTest, PicksTheStrokeThatIsPressedInTheList)
{
    DrawingModel model;
    add_curves(model, 1000);
    work({ 1280, 720 },
         { { { 200, 300 } }, { { 200, 300 } }, { { 200, 300 }, true }, { { 200, 300 }, false } },
         model, [](Layout& layout) { layout.workspace().shown = Workspace::Shown::Strokes; });
    ASSERT_EQ(model.picked.size(), 1u);
    EXPECT_GT(model.picked[0], 980u) << "the list shows the newest";
}

} // namespace tractus::window
