#include "app/controllers/replay_window.h"
#include "app/methods/all_methods.h"
#include "app/play/simulated_recording.h"
#include "app/window/view_curves.h"
#include "drivers/logs/log.h"
#include "tests/app/window/layout_fixture.h"

#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sstream>
#include <vector>

// Tests that the first plant of an empty sheet can be seen while its first stroke is drawn, with
// each method: in the views' pictures as the user sees them, from the drawn lines' places on the
// pad to the plant's picture.
namespace tractus::window {

using namespace layout_tests;

namespace {

struct FirstStroke {
    char const* method = "";
    std::string gesture {}; // The gesture of the simulated hand.
    // True if the first line of the preview follows the ink.
    bool axis_follows_ink = true;
};

std::string line(char const* tool, Vec3 const& from_mm, Vec3 const& to_mm)
{
    return fmt::format("[[gesture]]\ntool = \"{}\"\npath = \"line\"\nfrom_mm = [{}, {}, {}]\n"
                       "to_mm = [{}, {}, {}]\nspeed_mm_s = 60\n",
                       tool, from_mm.x(), from_mm.y(), from_mm.z(), to_mm.x(), to_mm.y(),
                       to_mm.z());
}

std::string ellipse(char const* tool, Vec2 const& foot_mm, Vec2 const& size_mm)
{
    std::string points;
    for (int i = 0; i <= 24; ++i) {
        double const angle = i * 2 * kPi / 24 - kPi / 2;
        points += fmt::format("[{:.2f}, {:.2f}, 60], ",
                              foot_mm.x() + size_mm.x() / 2 * std::cos(angle),
                              foot_mm.y() + size_mm.y() / 2 * (1 + std::sin(angle)));
    }
    return fmt::format("[[gesture]]\ntool = \"{}\"\npath = \"polyline\"\npoints_mm = [{}]\n"
                       "speed_mm_s = 90\n",
                       tool, points);
}

std::vector<FirstStroke> first_strokes()
{
    return {
        { "rule, in space", line("sketch", { 40, -20, 20 }, { 70, 10, 160 }), false },
        { "rule, on paper", line("sketch", { 40, -50, 60 }, { 48, 50, 60 }) },
        { "rule, on paper, aslant", line("sketch", { -60, -60, 60 }, { -100, 55, 60 }) },
        { "trunk", line("outline", { 20, -60, 60 }, { 24, 40, 60 }) },
        { "stem", line("construction_line", { -40, -55, 60 }, { -30, 45, 60 }) },
        { "leaf", ellipse("leaf_line", { 10, -30 }, { 40, 80 }), false },
    };
}

// A view's picture, as it is on the graphics card.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels {}; // RGBA.
};

Picture read_texture(GLuint texture)
{
    Picture picture;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &picture.width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &picture.height);
    picture.pixels.resize(static_cast<std::size_t>(picture.width * picture.height) * 4);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
    return picture;
}

// Returns the greater of the shares of the picture's width and height that its coloured part takes.
// Backgrounds, grids and the ground are grey or nearly so.
double share_of_color(Picture const& picture)
{
    constexpr int kColored = 40; // Least difference of the channels.
    Eigen::AlignedBox2i box;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            auto const* const p
                = &picture.pixels[static_cast<std::size_t>(y * picture.width + x) * 4];
            auto const [least, most] = std::minmax({ p[0], p[1], p[2] });
            if (most - least >= kColored)
                box.extend(Eigen::Vector2i(x, y));
        }
    if (box.isEmpty())
        return 0;
    return std::max((box.sizes().x() + 1.0) / picture.width,
                    (box.sizes().y() + 1.0) / picture.height);
}

// Strokes that reach less far than this make tiny plants in a view that has room for more.
constexpr float kTiny_mm = 25;

// Returns the greatest distance of the preview's first line from the ink, on the pad and in
// millimetres.
double off_the_ink_mm(view::WindowState const& state)
{
    auto const axis = pad_preview_curves(state).front();
    auto const& ink = state.live_ink.front().points;
    double most = 0;
    for (auto const& node : axis.points) {
        double least = std::numeric_limits<double>::infinity();
        for (auto const& point : ink)
            least = std::min(
                least,
                static_cast<double>((node.position_mm - point.position_mm).head<2>().norm()));
        most = std::max(most, least);
    }
    return most;
}

// Returns the scale of the pad, which shows the whole surface with some space around it.
double pad_px_per_mm(view::WindowState const& state, Picture const& pad)
{
    Vec2 const size_mm = state.surface_size_mm();
    return std::min(pad.width / size_mm.x(), pad.height / size_mm.y());
}

class FirstStrokeTest : public LayoutTest, public testing::WithParamInterface<std::size_t> {
protected:
    void SetUp() override
    {
        LayoutTest::SetUp();
        glDisable(GL_RASTERIZER_DISCARD); // The pictures are looked at.
        ImGui::CreateContext();
        auto& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = { 1600, 900 };
        io.DeltaTime = 1.0f / 30;
        auto* const title = theme::apply(1);
        io.Fonts->Build();
        io.Fonts->TexID = reinterpret_cast<ImTextureID>(std::uintptr_t { 0xF0F0 });
        layout_.emplace(title, 1.0f);
    }
    void TearDown() override
    {
        layout_.reset();
        ImGui::DestroyContext();
    }

    static FirstStroke stroke() { return first_strokes()[GetParam()]; }

    // Shows a frame and returns the pictures of its views, in the order of their places from left
    // to right and from top to bottom: pad, strokes, skeleton, plant.
    std::vector<Picture> frame(view::WindowModel& window)
    {
        PenPointer const pen;
        ImGui::NewFrame();
        layout_->show(window, *renderer_, pen, {});
        ImGui::Render();
        std::vector<std::pair<Vec2f, GLuint>> views;
        auto const* const data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i)
            for (auto const& command : data->CmdLists[i]->CmdBuffer) {
                if (command.TextureId == ImGui::GetIO().Fonts->TexID || command.ElemCount == 0)
                    continue;
                auto const& list = *data->CmdLists[i];
                auto const index
                    = list.IdxBuffer[static_cast<int>(command.IdxOffset)] + command.VtxOffset;
                auto const& corner = list.VtxBuffer[static_cast<int>(index)].pos;
                auto const texture
                    = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.TextureId));
                views.emplace_back(Vec2f(corner.x, corner.y), texture);
            }
        std::ranges::sort(views, [](auto const& one, auto const& other) {
            return std::pair(one.first.x(), one.first.y())
                < std::pair(other.first.x(), other.first.y());
        });
        std::vector<Picture> pictures;
        for (auto const& view : views)
            pictures.push_back(read_texture(view.second));
        return pictures;
    }

    std::optional<Layout> layout_;
};

} // namespace

TEST_P(FirstStrokeTest, IsSeenToGrow)
{
    auto const [method, gesture, axis_follows_ink] = stroke();
    SCOPED_TRACE(method);
    auto const script = sim::parse_gesture_script("version = 1\nseed = 5\n" + gesture, "script");
    ASSERT_TRUE(script) << script.error().message;
    std::ostringstream text;
    ASSERT_TRUE(play::write_simulated_recording(text, *script, scene::Scene {},
                                                methods::all_methods().tools));
    auto const log = drivers::parse_log(text.str(), "hand").value();
    auto window = controllers::ReplayWindow::create(log, { .methods = methods::all_methods() },
                                                    scene::Scene {}, ".")
                      .value();
    std::vector<double> heights; // Of what the skeleton's view has framed, without repetition.
    std::size_t seen = 0;
    std::size_t frames = 0;
    for (; window.state().playing && frames < 3000; ++frames) {
        window.advance(std::chrono::milliseconds(33));
        window.settle();
        auto const& state = window.state();
        if (!state.pen.touching || state.live_ink.empty() || state.preview.empty())
            continue;
        auto const& box_mm = state.skeleton_box_mm;
        if (heights.empty() || heights.back() != box_mm.max_mm.z())
            heights.push_back(box_mm.max_mm.z());
        auto const pictures = frame(window);
        ASSERT_EQ(pictures.size(), 4u);
        ++seen;
        auto const& ink = state.live_ink.front().points;
        float reach_mm = 0;
        for (auto const& point : ink)
            reach_mm = std::max(reach_mm, (point.position_mm - ink.front().position_mm).norm());
        if (reach_mm < kTiny_mm)
            continue;
        for (std::size_t const view : { 2u, 3u }) {
            EXPECT_GE(share_of_color(pictures[view]), 0.25) << "view " << view << ", " << seen;
            EXPECT_LE(share_of_color(pictures[view]), 0.95) << "view " << view << ", " << seen;
        }
        if (axis_follows_ink) {
            EXPECT_LE(off_the_ink_mm(state) * pad_px_per_mm(state, pictures[0]), 2);
        }
    }
    ASSERT_GT(seen, 10u);
    // Views zoom in few steps, not with each application of a rule.
    EXPECT_LE(heights.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(heights));
    // After pen-up the plant is there, framed by itself.
    window.settle();
    auto const pictures = frame(window);
    ASSERT_EQ(pictures.size(), 4u);
    EXPECT_TRUE(window.state().preview.empty());
    EXPECT_FALSE(window.state().is_first_plant_drawn);
    EXPECT_GE(share_of_color(pictures[3]), 0.3);
    EXPECT_LE(share_of_color(pictures[3]), 0.98);
}

INSTANTIATE_TEST_SUITE_P(Methods, FirstStrokeTest,
                         testing::Range<std::size_t>(0, first_strokes().size()));

} // namespace tractus::window
