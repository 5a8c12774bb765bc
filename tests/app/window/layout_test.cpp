#include "tests/app/window/layout_fixture.h"

#include <gtest/gtest.h>

namespace tractus {

using namespace layout_tests;

TEST_F(LayoutTest, ShowsEveryButtonOfEachToolWhole)
{
    auto const methods = all_methods();
    for (auto const& size : sizes())
        for (auto const& choice : tool_choices(methods.tools, {})) {
            SCOPED_TRACE(fmt::format("{}, {}", text_of(size), choice.text));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout&, DrawingModel& model) { model.perform(ChooseTool { choice.tool }); },
                check_buttons);
        }
}

TEST_F(LayoutTest, ShowsThePlantBesideTheMenuThatChangesIt)
{
    using Page = Workbench::MenuPage;
    for (auto const& size : sizes())
        for (auto const page : { Page::Plant, Page::Keep, Page::Window }) {
            SCOPED_TRACE(fmt::format("{}, page {}", text_of(size), static_cast<int>(page)));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout& layout, DrawingModel&) { layout.bench().open_menu(page); },
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

// For a left hand the menu is on the other side of the plant.
TEST_F(LayoutTest, ShowsThePlantBesideTheMenuOfALeftHand)
{
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [&](Layout& layout, DrawingModel&) {
                layout.bench().is_left_handed = true;
                layout.bench().open_menu(Workbench::MenuPage::Window);
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

} // namespace tractus
