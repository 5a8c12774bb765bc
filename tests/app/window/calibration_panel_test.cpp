#include "app/window/palette.h"
#include "app/window/window.h"
#include "engine/base/file.h"
#include "tests/app/render/read_png.h"
#include "tests/app/window/still_calibration.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::window {
namespace {

// A window that shows a calibration that does not change.
class StillWindow : public view::WindowModel {
public:
    void advance(Duration) override { }
    view::WindowState const& state() const override { return state_; }
    void perform(view::WindowCommand const&) override { }
    calibration::CalibrationModel* calibration() override { return &still; }

    StillCalibration still {};

private:
    view::WindowState state_;
};

// Returns the number of pixels whose colour differs from `srgb` by at most 12 levels.
int colored(render::Image const& picture, Vec3f const& srgb)
{
    auto const wanted = render::color_from(srgb);
    auto const near = [](std::uint8_t a, std::uint8_t b) { return std::abs(a - b) <= 12; };
    int count = 0;
    for (auto const& pixel : picture.pixels())
        count += near(pixel.red, wanted.red) && near(pixel.green, wanted.green)
            && near(pixel.blue, wanted.blue);
    return count;
}

TEST(CalibrationPanel, ShowsCapturesAndPlots)
{
    auto const path = std::filesystem::temp_directory_path()
        / ("tractus_calibration_" + std::to_string(::getpid()) + ".png");
    StillWindow model;
    auto const shown
        = run_window(model, { .width = 1500, .height = 900, .frames = 3, .screenshot = path });
    ASSERT_TRUE(shown) << shown.error().message;
    auto const picture = render::read_png(read_file(path).value());
    std::filesystem::remove(path);
    EXPECT_GT(colored(picture, theme::palette().assigned), 2000) << "the fit's curves";
    EXPECT_GT(colored(picture, theme::palette().selected), 5000)
        << "the noise, and captures from below";
    EXPECT_GT(colored(picture, theme::palette().stroke), 300) << "captures from above";
    EXPECT_GT(colored(picture, { 0.93f, 0.40f, 0.33f }), 200) << "the slip";
    EXPECT_EQ(model.still.commands, 0);
}

} // namespace
} // namespace tractus::window
