#pragma once

#include "app/methods/all_methods.h"
#include "app/render/offscreen_context.h"
#include "app/tools/tool_choices.h"
#include "app/window/layout.h"
#include "app/window/theme.h"
#include "tests/app/window/small_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <fmt/core.h>
#include <functional>
#include <gtest/gtest.h>
#include <imgui_internal.h>
#include <optional>
#include <string>
#include <vector>

// Fixture that draws the window without a display, to test the positions of its elements.
namespace tractus::window::layout_tests {

// A start page with the given number of recent drawings, whose pictures are as large as those of
// models.
class CardsModel : public view::StartPageModel {
public:
    explicit CardsModel(std::size_t recent)
    {
        auto const picture
            = std::make_shared<render::Image const>(360, 300, render::Color { 90, 120, 60 });
        view::StartCard const model { "Broadleaf", "A broadleaf tree like a young lime", picture };
        view::StartCard const drawing { "Lombardy poplar", "28 February, 23:59", picture };
        view::StartCard const sheet {
            "Along a stroke", "A rule grows along the stroke", {}, "5095 5050", 'K'
        };
        state_.groups = { { "An empty sheet", std::vector<view::StartCard>(3, sheet), {} },
                          { "From a model", std::vector<view::StartCard>(14, model), {} } };
        if (recent > 0)
            state_.groups.insert(state_.groups.begin() + 1,
                                 { "Recent drawings", std::vector<view::StartCard>(recent, drawing),
                                   "Earlier drawings" });
    }

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override { chosen.emplace_back(group, card); }
    void show_study()
    {
        auto const picture
            = std::make_shared<render::Image const>(64, 64, render::Color { 90, 120, 60 });
        view::StartStudy::Picture const shown { "light through", picture };
        state_.study = view::StartStudy {
            .large = shown,
            .details = std::vector<view::StartStudy::Picture>(4, shown),
            .others = std::vector<view::StartStudy::Picture>(6, shown),
            .sliders = std::vector<view::StartStudy::Slider>(7, { "spots 100 %", 1, 0.2 }),
            .accept = "Put on the plant"
        };
    }
    void slide(std::size_t slider, double value) override { slid.emplace_back(slider, value); }
    void accept() override { ++accepted; }
    void say(std::string note) { state_.note = std::move(note); }

    std::vector<std::pair<std::size_t, std::size_t>> chosen {};
    std::vector<std::pair<std::size_t, double>> slid {};
    int accepted = 0;

private:
    view::StartPageState state_;
};

class DrawingModel : public view::WindowModel {
public:
    DrawingModel()
        : methods_(methods::all_methods())
        , mesh_(render::post_with_leaves())
    {
        state_ = small_state();
        state_.plant = &mesh_;
        state_.plant_revision = 1;
        state_.tools = methods_.tools;
        state_.hand = tools::Tool(*state_.tools.front());
        state_.is_live = true;
        state_.mouse_draws = true;
        state_.mouse_moves_surface = true;
        state_.has_session = true;
        state_.may_calibrate = true;
    }

    void advance(Duration) override { }
    view::WindowState const& state() const override { return state_; }
    view::StartPageModel* start_page() override { return start ? &*start : nullptr; }
    calibration::CalibrationModel* calibration() override { return calibrated; }
    void perform(view::WindowCommand const& command) override
    {
        if (auto const* const choice = std::get_if<view::ChooseTool>(&command))
            state_.hand = choice->tool;
        if (auto const* const adjusted = std::get_if<view::AdjustTool>(&command)) {
            bool const moves = adjusted->slider == view::ChangeGrowth::Slider::Moving;
            if (!moves)
                state_.hand = adjusted->tool;
            (moves ? moved : released).push_back(adjusted->tool);
        }
        if (auto const* const named = std::get_if<view::NameDrawing>(&command))
            given_names.push_back(named->name);
        if (auto const* const asked = std::get_if<view::RequestCollection>(&command)) {
            collections.push_back(*asked);
            state_.individuality = asked->individuality;
        }
        if (auto const* const change = std::get_if<view::ChangeGrowth>(&command))
            state_.growth = change->growth;
        if (auto const* const pick = std::get_if<view::PickCurve>(&command))
            picked.push_back(pick->curve);
        if (auto const* const moved_by = std::get_if<view::MoveSurface>(&command))
            surface_mm += moved_by->by_mm;
        if (auto const* const pen = std::get_if<view::MoveMousePen>(&command))
            touches += std::any_of(pen->path.begin(), pen->path.end(),
                                   [](view::MousePen const& moment) { return moment.touching; });
    }

    void draw_curves(std::vector<view::DrawnCurveView> curves)
    {
        state_.curves = std::move(curves);
        ++state_.curves_revision;
    }
    void name(std::string drawing) { state_.drawing_name = std::move(drawing); }
    void add_card(tools::ToolCard card) { state_.cards.push_back(std::move(card)); }

    std::vector<tools::Tool> moved {};       // Settings of a tool while a slider is being dragged.
    std::vector<tools::Tool> released {};    // Settings of a tool when a slider is released.
    std::vector<std::string> given_names {}; // Names that the user has given to the drawing.
    std::vector<view::RequestCollection> collections {}; // Collections that the user has asked for.
    std::vector<std::size_t> picked {};                  // Drawn curves that the user has clicked.
    std::size_t touches = 0;
    double surface_mm = 0; // Distance by which the user has moved the surface.

    std::optional<CardsModel> start {};
    calibration::CalibrationModel* calibrated
        = nullptr; // Calibration that is shown instead of the drawing; not owned.

private:
    tools::Methods methods_;
    mesh::Mesh mesh_;
    view::WindowState state_;
};

struct Box {
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;
    std::string panel {}; // Name of the ImGui window that contains the box.

    float width() const { return right - left; }
    float height() const { return bottom - top; }
};

inline std::string text_of(Box const& box)
{
    return fmt::format("{} {:.0f},{:.0f} to {:.0f},{:.0f}", box.panel, box.left, box.top, box.right,
                       box.bottom);
}

inline bool overlap(Box const& one, Box const& other)
{
    // Boxes may overlap by this much, since their edges are smoothed.
    constexpr float kTouch_px = 1.5f;
    return std::min(one.right, other.right) - std::max(one.left, other.left) > kTouch_px
        && std::min(one.bottom, other.bottom) - std::max(one.top, other.top) > kTouch_px;
}

Box cut(Box box, ImVec4 const& clip)
{
    box.left = std::max(box.left, clip.x);
    box.top = std::max(box.top, clip.y);
    box.right = std::min(box.right, clip.z);
    box.bottom = std::min(box.bottom, clip.w);
    return box;
}

// The elements of a frame, found in the vertices that are sent to the graphics card. So they are
// what the user sees.
struct DrawnFrame {
    struct Button {
        Box whole;
        Box visible;
    };
    std::vector<Button> buttons {};
    std::vector<Box> pictures {}; // Boxes in which the window shows its views.
};

constexpr ImU32 kWithoutAlpha = ~IM_COL32_A_MASK;

inline bool is_button(ImU32 color)
{
    auto const is = [&](ImGuiCol what) {
        return (color & kWithoutAlpha) == (ImGui::GetColorU32(what) & kWithoutAlpha);
    };
    return is(ImGuiCol_Button) || is(ImGuiCol_CheckMark) || is(ImGuiCol_ButtonHovered);
}

// Finds the buttons of a frame. Each run of successive vertices in a button's colour is one button.
inline void find_drawn(ImDrawList const& list, DrawnFrame& drawn)
{
    auto const font = ImGui::GetIO().Fonts->TexID;
    for (auto const& command : list.CmdBuffer) {
        std::optional<Box> box;
        bool was_button = false;
        auto const end_run = [&] {
            auto const found = std::exchange(box, std::nullopt);
            if (!found)
                return;
            auto const visible = cut(*found, command.ClipRect);
            if (command.TextureId != font)
                drawn.pictures.push_back(visible);
            else if (was_button && found->height() > 8)
                drawn.buttons.push_back({ *found, visible });
        };
        for (unsigned i = 0; i < command.ElemCount; ++i) {
            auto const index
                = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)] + command.VtxOffset;
            auto const& vertex = list.VtxBuffer[static_cast<int>(index)];
            bool const is_one = command.TextureId == font && is_button(vertex.col);
            if (is_one != was_button)
                end_run();
            was_button = is_one;
            if (!is_one && command.TextureId == font)
                continue;
            if (!box)
                box = Box { vertex.pos.x, vertex.pos.y, vertex.pos.x, vertex.pos.y,
                            list._OwnerName };
            box->left = std::min(box->left, vertex.pos.x);
            box->top = std::min(box->top, vertex.pos.y);
            box->right = std::max(box->right, vertex.pos.x);
            box->bottom = std::max(box->bottom, vertex.pos.y);
        }
        end_run();
    }
}

class LayoutTest : public testing::Test {
protected:
    void SetUp() override
    {
        auto context = render::OffscreenContext::create();
        ASSERT_TRUE(context) << context.error().message;
        context_.emplace(std::move(*context));
        renderer_.emplace(render::Renderer::create().value());
        glEnable(GL_RASTERIZER_DISCARD); // Pixels are not needed, only the positions of vertices.
    }

    using Prepare = std::function<void(Layout&, DrawingModel&)>;
    // A check of the elements of a frame in a window of the given size.
    using Check = std::function<void(DrawnFrame const&, ImVec2 const&)>;

    // Shows a window of the given size, in points. Calls `prepare` before the last frames, and
    // `check` after them.
    void show(ImVec2 const& points, float scale, Prepare const& prepare, Check const& check)
    {
        ImGui::CreateContext();
        {
            auto& io = ImGui::GetIO();
            io.IniFilename = nullptr;
            io.DisplaySize = { std::round(points.x * scale), std::round(points.y * scale) };
            io.DeltaTime = 0.02f;
            io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
            auto* const title = theme::apply(scale);
            io.Fonts->Build();
            io.Fonts->TexID = reinterpret_cast<ImTextureID>(std::uintptr_t { 0xF0F0 });
            Layout layout(title, scale);
            DrawingModel model;
            PenPointer const pen;
            for (int frame = 0; frame < 4; ++frame) {
                if (frame == 1)
                    prepare(layout, model);
                ImGui::NewFrame();
                layout.show(model, *renderer_, pen, {});
                ImGui::Render();
            }
            DrawnFrame drawn;
            auto const* const data = ImGui::GetDrawData();
            for (int i = 0; i < data->CmdListsCount; ++i)
                find_drawn(*data->CmdLists[i], drawn);
            check(drawn, io.DisplaySize);
        }
        ImGui::DestroyContext();
    }

    // Input in one frame: the position of the mouse, the state of its button, and the keys pressed.
    struct Moment {
        ImVec2 place_px;
        bool is_down = false;
        HandInput input {};
        std::string typed {}; // Text typed on the keyboard in this frame.
    };

    // Shows the page in a window of the given size, in points, with the given input in successive
    // frames. Calls `look` at the end.
    void work(
        ImVec2 const& points, std::vector<Moment> const& moments, DrawingModel& model,
        std::function<void(Layout&)> const& prepare = [](Layout&) {},
        std::function<void(Layout&)> const& look = [](Layout&) {})
    {
        ImGui::CreateContext();
        {
            auto& io = ImGui::GetIO();
            io.IniFilename = nullptr;
            io.DisplaySize = points;
            io.DeltaTime = 0.02f;
            auto* const title = theme::apply(1);
            io.Fonts->Build();
            Layout layout(title, 1);
            prepare(layout);
            PenPointer const pen;
            for (auto const& moment : moments) {
                io.MousePos = moment.place_px;
                io.MouseDown[0] = moment.is_down;
                io.AddInputCharactersUTF8(moment.typed.c_str());
                ImGui::NewFrame();
                layout.show(model, *renderer_, pen, moment.input);
                ImGui::Render();
            }
            look(layout);
        }
        ImGui::DestroyContext();
    }

    std::optional<render::OffscreenContext> context_;
    std::optional<render::Renderer> renderer_;
};

struct Size {
    float width;
    float height;
    float scale;
};

// Returns the window sizes to test, in points, for displays of up to 3840 x 2160 pixels.
inline std::vector<Size> sizes()
{
    std::vector<Size> all;
    for (auto const& [width, height] :
         std::array<std::pair<float, float>, 8> { { { 533, 400 },
                                                    { 640, 480 },
                                                    { 800, 600 },
                                                    { 799, 450 },
                                                    { 1000, 560 },
                                                    { 1280, 720 },
                                                    { 1600, 900 },
                                                    { 1920, 1080 } } })
        for (float const scale : { 1.0f, 2.0f })
            if (width * scale <= 3840 && height * scale <= 2160)
                all.push_back({ width, height, scale });
    return all;
}

// True if the box is in a panel that the user can scroll by dragging up and down.
inline bool scrolls(Box const& box)
{
    return box.panel.find("meanings") != std::string::npos || box.panel == "menu"
        || box.panel.find("cards") != std::string::npos
        || box.panel.find("study") != std::string::npos
        || box.panel.find("individuality") != std::string::npos;
}

inline void check_buttons(DrawnFrame const& drawn, ImVec2 const& size_px)
{
    constexpr float kEdge_px = 1.5f;
    EXPECT_GT(drawn.buttons.size(), 5u);
    for (auto const& [whole, visible] : drawn.buttons) {
        EXPECT_GE(whole.left, -kEdge_px) << text_of(whole);
        EXPECT_LE(whole.right, size_px.x + kEdge_px) << text_of(whole);
        EXPECT_GE(visible.width(), whole.width() - kEdge_px) << text_of(whole) << " is cut";
        if (scrolls(whole))
            continue;
        EXPECT_GE(whole.top, -kEdge_px) << text_of(whole);
        EXPECT_LE(whole.bottom, size_px.y + kEdge_px) << text_of(whole);
        EXPECT_GE(visible.height(), whole.height() - kEdge_px) << text_of(whole) << " is cut";
    }
    for (std::size_t i = 0; i < drawn.buttons.size(); ++i)
        for (std::size_t j = i + 1; j < drawn.buttons.size(); ++j)
            EXPECT_FALSE(overlap(drawn.buttons[i].visible, drawn.buttons[j].visible)
                         && drawn.buttons[i].visible.height() > 0
                         && drawn.buttons[j].visible.height() > 0)
                << text_of(drawn.buttons[i].whole) << " and " << text_of(drawn.buttons[j].whole);
}

inline std::string text_of(Size const& size)
{
    return fmt::format("{} x {} points at {}", size.width, size.height, size.scale);
}

} // namespace tractus::window::layout_tests
