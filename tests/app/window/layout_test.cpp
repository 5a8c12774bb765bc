#include "tests/app/window/layout_fixture.h"

#include <gtest/gtest.h>

namespace tractus::window {

using namespace layout_tests;

TEST_F(LayoutTest, ShowsEveryButtonOfEachToolWhole)
{
    auto const methods = methods::all_methods();
    for (auto const& size : sizes())
        for (auto const& choice : tools::tool_choices(methods.tools, {})) {
            SCOPED_TRACE(fmt::format("{}, {}", text_of(size), choice.text));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout&, DrawingModel& model) {
                    model.perform(view::ChooseTool { choice.tool });
                },
                check_buttons);
        }
}

TEST_F(LayoutTest, ShowsThePlantBesideTheMenuThatChangesIt)
{
    using Page = Workspace::MenuPage;
    for (auto const& size : sizes())
        for (auto const page : { Page::Plant, Page::Keep, Page::Window }) {
            SCOPED_TRACE(fmt::format("{}, page {}", text_of(size), static_cast<int>(page)));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout& layout, DrawingModel&) { layout.workspace().open_menu(page); },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    check_buttons(drawn, size_px);
                    auto const* const menu = ImGui::FindWindowByName("menu");
                    ASSERT_NE(menu, nullptr);
                    ASSERT_FALSE(drawn.pictures.empty());
                    auto const& plant = drawn.pictures.back();
                    EXPECT_LE(plant.right, menu->Pos.x + 1) << text_of(plant);
                    EXPECT_GE(plant.width(), 100 * size.scale) << text_of(plant);
                    EXPECT_GE(plant.height(), 100 * size.scale) << text_of(plant);
                });
        }
}

// For a left-handed user, the menu must be on the other side of the plant.
TEST_F(LayoutTest, ShowsThePlantBesideTheMenuOfALeftHand)
{
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [&](Layout& layout, DrawingModel&) {
                layout.workspace().is_left_handed = true;
                layout.workspace().open_menu(Workspace::MenuPage::Window);
            },
            [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                check_buttons(drawn, size_px);
                auto const* const menu = ImGui::FindWindowByName("menu");
                ASSERT_NE(menu, nullptr);
                EXPECT_EQ(menu->Pos.x, 0);
                ASSERT_FALSE(drawn.pictures.empty());
                auto const& plant = drawn.pictures.back();
                EXPECT_GE(plant.left, menu->Size.x - 1) << text_of(plant);
                EXPECT_LE(plant.right, size_px.x + 1) << text_of(plant);
                EXPECT_GE(plant.width(), 100 * size.scale) << text_of(plant);
            });
    }
}

// On stage, only the growing plant may be visible, whatever was open in the window before.
TEST_F(LayoutTest, ShowsNothingOnStageButWhatGrows)
{
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [&](Layout& layout, DrawingModel&) {
                layout.workspace().open_menu(Workspace::MenuPage::Window);
                layout.workspace().keys_are_listed = true;
                layout.workspace().enter_stage();
            },
            [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                EXPECT_TRUE(drawn.buttons.empty()) << text_of(drawn.buttons.front().whole);
                ASSERT_EQ(drawn.pictures.size(), 1u);
                EXPECT_GE(drawn.pictures.front().width(), size_px.x);
                EXPECT_GE(drawn.pictures.front().height(), size_px.y);
                EXPECT_EQ(ImGui::GetDrawData()->TotalVtxCount, 8) << "corners of it and its ground";
            });
    }
}

TEST_F(LayoutTest, LetsTheMouseDrawOnStageUntilEscape)
{
    DrawingModel model;
    HandInput drawing;
    drawing.mouse = { { .place_px = { 600, 400 }, .is_down = true } };
    HandInput escape;
    escape.presses = { { .key = KeyPress::kEscape } };
    bool is_on_stage = true;
    bool is_close_requested = false;
    work(
        { 1280, 720 },
        { { { 600, 400 } }, { { 600, 400 }, true, drawing }, { { 600, 400 }, false, escape } },
        model, [](Layout& layout) { layout.workspace().is_on_stage = true; },
        [&](Layout& layout) {
            is_on_stage = layout.workspace().is_on_stage;
            is_close_requested = layout.take_close_request();
        });
    EXPECT_GE(model.touches, 1u);
    EXPECT_FALSE(is_on_stage);
    EXPECT_FALSE(is_close_requested);
}

namespace {

// Returns the boxes of the switches beside a collection, from top to bottom.
std::vector<Box> switches(DrawnFrame const& drawn)
{
    std::vector<Box> boxes;
    for (auto const& [whole, visible] : drawn.buttons)
        if (whole.panel.find("individuality") != std::string::npos)
            boxes.push_back(whole);
    std::ranges::sort(boxes, {}, &Box::top);
    return boxes;
}

void show_many(Layout& layout)
{
    layout.workspace().shown = Workspace::Shown::Collection;
}

} // namespace

TEST_F(LayoutTest, HasASwitchForEachTraitOfACollection)
{
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [](Layout& layout, DrawingModel&) { show_many(layout); },
            [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                check_buttons(drawn, size_px);
                EXPECT_GE(switches(drawn).size(), 2u);
                if (size.height >= 900)
                    EXPECT_EQ(switches(drawn).size(), 7u);
            });
    }
}

TEST_F(LayoutTest, SwitchesATraitOfACollectionOffAndOnAgain)
{
    std::vector<Box> boxes;
    show(
        { 1600, 900 }, 1, [](Layout& layout, DrawingModel&) { show_many(layout); },
        [&](DrawnFrame const& drawn, ImVec2 const&) { boxes = switches(drawn); });
    ASSERT_EQ(boxes.size(), 7u);
    auto const centre = [&](std::size_t i) {
        return ImVec2(boxes[i].left + boxes[i].width() / 2, boxes[i].top + boxes[i].height() / 2);
    };
    DrawingModel model;
    std::vector<Moment> moments { { { 10, 10 } } };
    for (auto const i : { 2u, 3u, 2u, 6u })
        for (bool const is_down : { false, true, false, false })
            moments.push_back({ centre(i), is_down });
    work({ 1600, 900 }, moments, model, show_many);
    auto const bed = variation::kPlantsOfOneBed;
    ASSERT_EQ(model.collections.size(), 4u) << "one when the view opens, and one for each switch";
    EXPECT_EQ(model.collections[0].individuality, bed);
    EXPECT_EQ(model.collections[0].count, 12u);
    auto how = bed;
    how.size = 0;
    EXPECT_EQ(model.collections[1].individuality, how);
    how.turn = 0;
    EXPECT_EQ(model.collections[2].individuality, how);
    how.size = bed.size;
    EXPECT_EQ(model.collections[3].individuality, how);
    EXPECT_EQ(model.state().growth.variability, 0) << "growth is the plant's own";
}

} // namespace tractus::window
