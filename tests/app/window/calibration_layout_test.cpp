#include "tests/app/window/layout_fixture.h"
#include "tests/app/window/still_calibration.h"

#include <gtest/gtest.h>

namespace tractus::window {

using namespace layout_tests;

// In a small window, everything must be reachable by scrolling down, never sideways.
TEST_F(LayoutTest, ShowsCalibratingInTheWindow)
{
    StillCalibration still;
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [&](Layout&, DrawingModel& model) { model.calibrated = &still; },
            [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                EXPECT_GE(drawn.buttons.size(), 8u);
                for (std::size_t i = 0; i < drawn.buttons.size(); ++i) {
                    auto const& [whole, visible] = drawn.buttons[i];
                    EXPECT_GE(whole.left, -1.5f) << text_of(whole);
                    EXPECT_LE(whole.right, size_px.x + 1.5f) << text_of(whole);
                    EXPECT_GE(visible.right, whole.right - 1.5f) << text_of(whole);
                    for (std::size_t k = 0; k < i; ++k)
                        EXPECT_FALSE(overlap(whole, drawn.buttons[k].whole))
                            << text_of(whole) << " and " << text_of(drawn.buttons[k].whole);
                }
            });
    }
}

} // namespace tractus::window
