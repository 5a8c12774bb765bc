#include "app/window/display.h"

#include <array>
#include <gtest/gtest.h>

namespace tractus::window {

namespace {

std::array const kScreens {
    Display { .name = "DELL U2720Q", .width_px = 3840, .height_px = 2160, .size_mm = { 597, 336 } },
    Display {
        .name = "Wacom Cintiq 16", .width_px = 1920, .height_px = 1080, .size_mm = { 344, 194 } },
    Display { .name = "DELL P2419H", .width_px = 1920, .height_px = 1080, .size_mm = { 527, 296 } },
};

} // namespace

TEST(Display, IsTheTabletsOwnIfItIsAsLarge)
{
    EXPECT_EQ(tablet_display(kScreens, { 344.16, 193.59 }), 1u);
    EXPECT_EQ(tablet_display(kScreens, { 193.59, 344.16 }), 1u) << "turned on its carriage";
    EXPECT_EQ(tablet_display(kScreens, { 350, 200 }), 1u) << "felt beyond the picture's edge";
    EXPECT_FALSE(tablet_display(kScreens, { 254, 159 })) << "a tablet without a display";
    EXPECT_FALSE(tablet_display({}, { 344, 194 }));
    std::array const twins { kScreens[1], kScreens[1] };
    EXPECT_FALSE(tablet_display(twins, { 344, 194 })) << "nobody knows which";
    std::array const unknown { Display { .name = "screen" } };
    EXPECT_FALSE(tablet_display(unknown, { 344, 194 }));
}

TEST(Display, IsFoundByNumberOrName)
{
    EXPECT_EQ(find_display(kScreens, "2").value(), 1u);
    EXPECT_EQ(find_display(kScreens, "cintiq").value(), 1u);
    EXPECT_EQ(find_display(kScreens, "P2419").value(), 2u);
    auto const both = find_display(kScreens, "dell");
    ASSERT_FALSE(both);
    EXPECT_EQ(both.error().fault, Fault::User);
    EXPECT_EQ(
        both.error().message,
        "\"dell\" names no display, or several: give the number or a part of the name of one "
        "of 1 DELL U2720Q (3840 x 2160), 2 Wacom Cintiq 16 (1920 x 1080), 3 DELL P2419H (1920 "
        "x 1080)");
    EXPECT_FALSE(find_display(kScreens, "4"));
    EXPECT_FALSE(find_display(kScreens, ""));
}

} // namespace tractus::window
