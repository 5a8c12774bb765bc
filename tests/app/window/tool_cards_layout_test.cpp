#include "tests/app/window/layout_fixture.h"

#include <gtest/gtest.h>

namespace tractus::window {

using namespace layout_tests;

TEST_F(LayoutTest, ShowsCardsOfToolsInTheWindow)
{
    for (auto const& size : sizes())
        for (auto const* const word : { "sketch", "outline" }) {
            SCOPED_TRACE(fmt::format("{}, {}", text_of(size), word));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout& layout, DrawingModel& model) {
                    tools::Tool const tool(
                        *tools::find_tool_kind(methods::all_methods().tools, word));
                    model.perform(view::ChooseTool { tool });
                    for (int i = 1; i <= 12; ++i)
                        model.add_card({ fmt::format("A card of a long name, {}", i), tool });
                    layout.workspace().cards_are_shown = true;
                },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    std::size_t cards = 0;
                    for (auto const& [whole, visible] : drawn.buttons) {
                        if (whole.panel.find("cards") == std::string::npos)
                            continue;
                        ++cards;
                        EXPECT_GE(whole.left, -1.5f) << text_of(whole);
                        EXPECT_LE(whole.right, size_px.x + 1.5f) << text_of(whole);
                        EXPECT_GE(visible.top, -1.5f) << text_of(whole);
                        EXPECT_LE(visible.bottom, size_px.y + 1.5f) << text_of(whole);
                    }
                    EXPECT_GE(cards, 6u);
                });
        }
}

TEST_F(LayoutTest, TakesACardIntoTheHand)
{
    DrawingModel model;
    tools::Tool const tool(*tools::find_tool_kind(methods::all_methods().tools, "sketch"));
    model.perform(view::ChooseTool { tool });
    auto const second = tools::ready_cards(tool)[1].tool;
    std::vector<Moment> moments { { { 0, 0 } }, { { 0, 0 } } };
    // Some of these positions are on the second card of the first row.
    for (float y = 300; y < 420; y += 20) {
        moments.push_back({ { 230, y } });
        moments.push_back({ { 230, y }, true });
        moments.push_back({ { 230, y } });
    }
    work({ 1600, 900 }, moments, model,
         [](Layout& layout) { layout.workspace().cards_are_shown = true; });
    EXPECT_EQ(model.state().hand, second);
}

// A drag may begin anywhere on the gizmo. If it begins on a handle, it must set the rule while
// moving and once at its end. It must never draw on the pad below.
TEST_F(LayoutTest, DragsTheHandlesOfTheRule)
{
    DrawingModel model;
    model.perform(view::ChooseTool {
        tools::Tool(*tools::find_tool_kind(methods::all_methods().tools, "sketch")) });
    std::vector<Moment> drags { { { 0, 0 } }, { { 0, 0 } } };
    for (float x = 355; x < 560; x += 16)
        for (float y = 70; y < 280; y += 16) {
            drags.push_back({ { x, y } });
            drags.push_back({ { x, y } });
            for (int i = 0; i <= 6; ++i)
                drags.push_back(
                    { { x - 6 * static_cast<float>(i), y + 7 * static_cast<float>(i) }, true });
            drags.push_back({ { x - 36, y + 42 } });
        }
    work({ 1600, 900 }, drags, model);
    EXPECT_GE(model.released.size(), 5u) << "handles move with the rule";
    EXPECT_GE(model.moved.size(), 2 * model.released.size());
    EXPECT_EQ(model.touches, 0u);
}

} // namespace tractus::window
