#include "app/window/palette.h"
#include "app/window/window.h"
#include "engine/base/file.h"
#include "tests/app/render/read_png.h"
#include "tests/app/window/small_state.h"

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace tractus::window {

namespace {

// A window model that shows a fixed state and counts the window's requests.
class StillModel : public view::WindowModel {
public:
    explicit StillModel(std::string trouble = {})
        : mesh_(render::post_with_leaves())
    {
        state_ = small_state();
        state_.trouble = std::move(trouble);
        state_.plant = &mesh_;
        state_.plant_revision = 1;
    }

    void advance(Duration real_step) override
    {
        ++steps;
        time += real_step;
    }
    view::WindowState const& state() const override { return state_; }
    void perform(view::WindowCommand const&) override { ++commands; }

    int steps = 0;
    Duration time {};
    int commands = 0;

private:
    mesh::Mesh mesh_;
    view::WindowState state_;
};

struct Part {
    int left = 0;
    int right = 0;
    int top = 60;
    int bottom = 660;
};

// Returns the number of pixels in a part of the picture whose colour differs from `srgb` by at most
// 12 levels.
int colored(render::Image const& picture, Part const& part, Vec3f const& srgb)
{
    auto const wanted = render::color_from(srgb);
    auto const near = [](std::uint8_t a, std::uint8_t b) { return std::abs(a - b) <= 12; };
    int count = 0;
    for (int y = part.top; y < part.bottom; ++y)
        for (int x = part.left; x < part.right; ++x) {
            auto const& pixel = picture.at(x, y);
            count += near(pixel.red, wanted.red) && near(pixel.green, wanted.green)
                && near(pixel.blue, wanted.blue);
        }
    return count;
}

} // namespace

class WindowTest : public testing::Test {
protected:
    void SetUp() override
    {
        path_ = std::filesystem::temp_directory_path()
            / ("tractus_window_" + std::to_string(::getpid()) + ".png");
    }
    void TearDown() override { std::filesystem::remove(path_); }

    render::Image last_frame(StillModel& model, bool is_light = false)
    {
        WindowOptions const options { .width = 1500,
                                      .height = 800,
                                      .frames = 3,
                                      .look = { .is_light = is_light },
                                      .screenshot = path_ };
        auto const result = run_window(model, options);
        if (!result) {
            ADD_FAILURE() << result.error().message;
            return {};
        }
        auto const bytes = read_file(path_);
        return bytes ? render::read_png(*bytes) : render::Image();
    }

    std::filesystem::path path_;
};

namespace {

constexpr Part kPad { 110, 550 };
constexpr Part kSkeleton { 620, 960, 60, 580 };
// The coloured lines of the legend; its words are beside them.
constexpr Part kLegend { 560, 620, 580, 660 };
constexpr Part kPlant { 990, 1480 };

} // namespace

TEST_F(WindowTest, ShowsPadSkeletonAndPlantSideBySide)
{
    StillModel model;
    auto const picture = last_frame(model);
    ASSERT_EQ(picture.width(), 1500);
    ASSERT_EQ(picture.height(), 800);
    int const whole_pad = (kPad.right - kPad.left) * (picture.height() - 200);
    EXPECT_LT(colored(picture, kPad, theme::palette().pad_background), whole_pad - 4000)
        << "no grid";
    EXPECT_GT(colored(picture, kPad, theme::palette().stroke), 40);
    EXPECT_GT(colored(picture, kPad, theme::palette().ink), 100);
    EXPECT_EQ(colored(picture, kSkeleton, theme::palette().ink), 0);
    EXPECT_GT(colored(picture, kSkeleton, theme::palette().unselected), 80);
    // Branches are shaded, so only their hue is compared.
    int blue = 0, green = 0;
    for (int y = kSkeleton.top; y < kSkeleton.bottom; ++y)
        for (int x = kSkeleton.left; x < kSkeleton.right; ++x) {
            auto const& pixel = picture.at(x, y);
            blue += pixel.blue > pixel.red + 40 && pixel.blue > pixel.green + 20;
            green += pixel.green > pixel.red + 40 && pixel.green > pixel.blue + 20;
        }
    EXPECT_GT(blue, 80) << "selected";
    EXPECT_GT(green, 80) << "shaped by a stroke";
    EXPECT_GT(colored(picture, kLegend, theme::palette().selected), 40);
    EXPECT_GT(colored(picture, kLegend, theme::palette().assigned), 40);
    EXPECT_GT(colored(picture, kLegend, theme::palette().indicator), 40);
    EXPECT_EQ(colored(picture, kLegend, theme::palette().undetermined), 0) << "none is";
    int leaf = 0;
    for (int y = 60; y < 660; ++y)
        for (int x = kPlant.left; x < kPlant.right; ++x) {
            auto const& pixel = picture.at(x, y);
            leaf += pixel.green > pixel.red + 15 && pixel.green > pixel.blue + 30;
        }
    EXPECT_GT(leaf, 2000);
}

TEST_F(WindowTest, SaysWhatIsWrongInPlaceOfTheStatus)
{
    constexpr Part kStatus { 0, 1500, 670, 735 };
    StillModel well;
    EXPECT_EQ(colored(last_frame(well), kStatus, theme::palette().indicator), 0);
    StillModel ill("height sensor silent for 3 s: is it plugged in?");
    EXPECT_GT(colored(last_frame(ill), kStatus, theme::palette().indicator), 200);
}

TEST_F(WindowTest, IsLightWhereTheRoomIs)
{
    StillModel model;
    auto const picture = last_frame(model, true);
    EXPECT_TRUE(theme::palette().is_light);
    EXPECT_GT(colored(picture, kPad, theme::palette().pad_background), 10'000);
    theme::use_light_palette(false);
}

TEST_F(WindowTest, StepsTheModelOncePerFrame)
{
    StillModel model;
    last_frame(model);
    EXPECT_EQ(model.steps, 3);
    EXPECT_NEAR(to_seconds(model.time), 3.0 / 60, 1e-6);
    EXPECT_EQ(model.commands, 0);
}

TEST_F(WindowTest, SaysWhatToDoWhereThereIsNoDisplay)
{
    auto const* const display = std::getenv("DISPLAY");
    std::string const before = display ? display : "";
    ::setenv("DISPLAY", ":32767", 1);
    StillModel model;
    auto const result = run_window(model, { .frames = 1 });
    ::setenv("DISPLAY", before.c_str(), 1);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::User);
    EXPECT_NE(result.error().message.find("there is no display"), std::string::npos)
        << result.error().message;
    EXPECT_NE(result.error().message.find("tractus demo -o DIR"), std::string::npos);
}

} // namespace tractus::window
