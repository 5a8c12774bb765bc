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

namespace tractus {
namespace {

// A page of so many recent drawings, and with pictures as large as those of models.
class CardsModel : public StartPageModel {
public:
    explicit CardsModel(std::size_t recent)
    {
        auto const picture = std::make_shared<Image const>(360, 300, Color { 90, 120, 60 });
        StartCard const model { "Broadleaf", "A broadleaf tree like a young lime", picture };
        StartCard const drawing { "Lombardy poplar", "28 February, 23:59", picture };
        StartCard const sheet {
            "Along a stroke", "A rule grows along the stroke", {}, "5095 5050", 'K'
        };
        state_.groups = { { "An empty sheet", std::vector<StartCard>(3, sheet), {} },
                          { "From a model", std::vector<StartCard>(14, model), {} } };
        if (recent > 0)
            state_.groups.insert(
                state_.groups.begin() + 1,
                { "Recent drawings", std::vector<StartCard>(recent, drawing), "Earlier drawings" });
    }

    StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override { chosen.emplace_back(group, card); }
    void show_study()
    {
        auto const picture = std::make_shared<Image const>(64, 64, Color { 90, 120, 60 });
        StartStudy::Picture const shown { "light through", picture };
        state_.study
            = StartStudy { .large = shown,
                           .details = std::vector<StartStudy::Picture>(4, shown),
                           .others = std::vector<StartStudy::Picture>(6, shown),
                           .sliders = std::vector<StartStudy::Slider>(7, { "spots 100 %", 1, 0.2 }),
                           .accept = "Put on the plant" };
    }
    void slide(std::size_t slider, double value) override { slid.emplace_back(slider, value); }
    void accept() override { ++accepted; }
    void say(std::string note) { state_.note = std::move(note); }

    std::vector<std::pair<std::size_t, std::size_t>> chosen {};
    std::vector<std::pair<std::size_t, double>> slid {};
    int accepted = 0;

private:
    StartPageState state_;
};

class DrawingModel : public WindowModel {
public:
    DrawingModel()
        : methods_(all_methods())
        , mesh_(post_with_leaves())
    {
        state_ = small_state();
        state_.plant = &mesh_;
        state_.plant_revision = 1;
        state_.tools = methods_.tools;
        state_.hand = Tool(*state_.tools.front());
        state_.is_live = true;
        state_.mouse_draws = true;
        state_.has_session = true;
        state_.may_calibrate = true;
    }

    void advance(Duration) override { }
    WindowState const& state() const override { return state_; }
    StartPageModel* start_page() override { return start ? &*start : nullptr; }
    void perform(WindowCommand const& command) override
    {
        if (auto const* const choice = std::get_if<ChooseTool>(&command))
            state_.hand = choice->tool;
        if (auto const* const adjusted = std::get_if<AdjustTool>(&command)) {
            bool const moves = adjusted->slider == ChangeGrowth::Slider::Moving;
            if (!moves)
                state_.hand = adjusted->tool;
            (moves ? moved : released).push_back(adjusted->tool);
        }
        if (auto const* const pen = std::get_if<MoveMousePen>(&command))
            touches += std::any_of(pen->path.begin(), pen->path.end(),
                                   [](MousePen const& moment) { return moment.touching; });
    }

    void add_card(ToolCard card) { state_.cards.push_back(std::move(card)); }

    std::vector<Tool> moved {};    // What tools in hand are adjusted to,
    std::vector<Tool> released {}; // and left as.
    std::size_t touches = 0;

    std::optional<CardsModel> start {};

private:
    Methods methods_;
    Mesh mesh_;
    WindowState state_;
};

struct Box {
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;
    std::string panel {}; // Name of ImGui's window.

    float width() const { return right - left; }
    float height() const { return bottom - top; }
};

std::string text_of(Box const& box)
{
    return fmt::format("{} {:.0f},{:.0f} to {:.0f},{:.0f}", box.panel, box.left, box.top, box.right,
                       box.bottom);
}

bool overlap(Box const& one, Box const& other)
{
    constexpr float kTouch_px = 1.5f; // Edges are smoothed.
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

// What a frame has drawn: as the graphics card gets it, not as the program means it.
struct DrawnFrame {
    struct Button {
        Box whole;
        Box visible;
    };
    std::vector<Button> buttons {};
    std::vector<Box> pictures {}; // The views.
};

constexpr ImU32 kWithoutAlpha = ~IM_COL32_A_MASK;

bool is_button(ImU32 color)
{
    auto const is = [&](ImGuiCol what) {
        return (color & kWithoutAlpha) == (ImGui::GetColorU32(what) & kWithoutAlpha);
    };
    return is(ImGuiCol_Button) || is(ImGuiCol_CheckMark) || is(ImGuiCol_ButtonHovered);
}

// Runs of neighbouring vertices in a button's colour are a button each.
void find_drawn(ImDrawList const& list, DrawnFrame& drawn)
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

} // namespace

class LayoutTest : public testing::Test {
protected:
    void SetUp() override
    {
        auto context = OffscreenContext::create();
        ASSERT_TRUE(context) << context.error().message;
        context_.emplace(std::move(*context));
        renderer_.emplace(Renderer::create().value());
        glEnable(GL_RASTERIZER_DISCARD); // Where things lie is looked at, not their pixels.
    }

    using Prepare = std::function<void(Layout&, DrawingModel&)>;
    using Check = std::function<void(DrawnFrame const&, ImVec2 const&)>; // Of a window so large.

    // Shows a window of that many points; `prepare` before the last frames.
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

    // Where ImGui's mouse is, and whether its button is down, in each of the frames; the keys that
    // are pressed in the first.
    struct Moment {
        ImVec2 place_px;
        bool is_down = false;
        HandInput input {};
    };

    // Shows the page in a window of that many points, and what a hand does there.
    void work(
        ImVec2 const& points, std::vector<Moment> const& moments, DrawingModel& model,
        std::function<void(Layout&)> const& prepare = [](Layout&) {})
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
                ImGui::NewFrame();
                layout.show(model, *renderer_, pen, moment.input);
                ImGui::Render();
            }
        }
        ImGui::DestroyContext();
    }

    std::optional<OffscreenContext> context_;
    std::optional<Renderer> renderer_;
};

namespace {

struct Size {
    float width;
    float height;
    float scale;
};

// Points, on displays of up to 3840 x 2160.
std::vector<Size> sizes()
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

// What does not fit is reached by dragging, up and down.
bool scrolls(Box const& box)
{
    return box.panel.find("meanings") != std::string::npos || box.panel == "menu"
        || box.panel.find("cards") != std::string::npos
        || box.panel.find("study") != std::string::npos;
}

void check_buttons(DrawnFrame const& drawn, ImVec2 const& size_px)
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

std::string text_of(Size const& size)
{
    return fmt::format("{} x {} points at {}", size.width, size.height, size.scale);
}

} // namespace

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

TEST_F(LayoutTest, ShowsEveryCardOfTheStartPageWhole)
{
    for (auto const& size : sizes())
        for (std::size_t const recent : { 0u, 2u, 12u }) {
            SCOPED_TRACE(fmt::format("{}, {} recent", text_of(size), recent));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout&, DrawingModel& model) {
                    model.start.emplace(recent);
                    if (recent == 2)
                        model.start->say("The drawing is kept as "
                                         "lombardy_poplar-2026-01-09-1403.tractus");
                },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    check_buttons(drawn, size_px);
                    EXPECT_GE(drawn.pictures.size(), size.height >= 560 ? 2u : 0u);
                    std::size_t whole = 0;
                    for (auto const& button : drawn.buttons)
                        whole += button.whole.panel.find("cards") != std::string::npos
                            && button.visible.height() > button.whole.height() - 1.5f;
                    EXPECT_GE(whole, 3u) << "the empty sheets are seen at once";
                });
        }
}

TEST_F(LayoutTest, ShowsAStudyWhole)
{
    for (auto const& size : sizes()) {
        SCOPED_TRACE(text_of(size));
        show(
            { size.width, size.height }, size.scale,
            [&](Layout&, DrawingModel& model) {
                model.start.emplace(0);
                model.start->show_study();
            },
            [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                ASSERT_GE(drawn.buttons.size(), 4u) << "of the head, and the study's own";
                ASSERT_EQ(drawn.pictures.size(), 11u);
                for (std::size_t i = 0; i < drawn.pictures.size(); ++i) {
                    auto const& picture = drawn.pictures[i];
                    EXPECT_GE(picture.left, 0) << text_of(picture);
                    EXPECT_LE(picture.right, size_px.x) << text_of(picture);
                    EXPECT_NEAR(picture.width(), picture.height(), 1) << "it is not cut";
                    EXPECT_GE(picture.width(), (i == 0 ? 140 : 32) * size.scale);
                    for (std::size_t j = 0; j < i; ++j)
                        EXPECT_FALSE(overlap(picture, drawn.pictures[j]));
                }
                auto const& accept = drawn.buttons.back();
                EXPECT_LE(accept.whole.right, size_px.x);
                if (size.height >= 450 && size.width >= 640) {
                    EXPECT_GE(accept.visible.height(), accept.whole.height() - 1.5f);
                }
            });
    }
}

TEST_F(LayoutTest, MovesASliderOfAStudyAndAcceptsIt)
{
    DrawingModel model;
    model.start.emplace(0);
    model.start->show_study();
    ImVec2 const slider { 650, 100 };
    work({ 800, 600 },
         { { slider },
           { slider, true },
           { { slider.x + 40, slider.y }, true },
           { { slider.x + 40, slider.y } },
           { slider, false, { {}, { { KeyPress::kEnter } }, {} } } },
         model);
    ASSERT_FALSE(model.start->slid.empty());
    EXPECT_EQ(model.start->slid.back().first, 0u);
    EXPECT_GT(model.start->slid.back().second, 0.4);
    EXPECT_EQ(model.start->accepted, 1);
    EXPECT_TRUE(model.start->chosen.empty());
}

static ImVec2 const kFirstCard { 110, 200 };

TEST_F(LayoutTest, PressesACardOnlyIfTheTouchStaysThere)
{
    DrawingModel model;
    model.start.emplace(12);
    std::vector<Moment> tap { { { 0, 0 } },         { { 0, 0 } },         { kFirstCard },
                              { kFirstCard, true }, { kFirstCard, true }, { kFirstCard },
                              { kFirstCard } };
    work({ 800, 600 }, tap, model);
    ASSERT_EQ(model.start->chosen.size(), 1u);
    EXPECT_EQ(model.start->chosen[0], std::pair(std::size_t { 0 }, std::size_t { 0 }));

    model.start->chosen.clear();
    std::vector<Moment> drag { { { 0, 0 } }, { { 0, 0 } }, { kFirstCard } };
    for (int i = 0; i <= 10; ++i)
        drag.push_back({ { kFirstCard.x, kFirstCard.y - 8 * static_cast<float>(i) }, true });
    drag.push_back({ { kFirstCard.x, kFirstCard.y - 80 } });
    drag.push_back({ { kFirstCard.x, kFirstCard.y - 80 } });
    work({ 800, 600 }, drag, model);
    EXPECT_TRUE(model.start->chosen.empty()) << "it has moved the page";
}

TEST_F(LayoutTest, PressesCardsByTheKeys)
{
    DrawingModel model;
    model.start.emplace(0);
    auto const press = [](char key) {
        return Moment { { 0, 0 }, false, { .mouse = {}, .presses = { { key } }, .held = {} } };
    };
    work({ 800, 600 },
         { { { 0, 0 } },
           press(KeyPress::kEnter),
           press(KeyPress::kDown),
           press(KeyPress::kDown),
           press(KeyPress::kRight),
           press(KeyPress::kEnter),
           press('K'),
           press('X') },
         model);
    ASSERT_EQ(model.start->chosen.size(), 2u);
    EXPECT_EQ(model.start->chosen[0], std::pair(std::size_t { 1 }, std::size_t { 1 }));
    EXPECT_EQ(model.start->chosen[1], std::pair(std::size_t { 0 }, std::size_t { 0 }));
}

TEST_F(LayoutTest, ShowsCardsOfToolsInTheWindow)
{
    for (auto const& size : sizes())
        for (auto const* const word : { "sketch", "outline" }) {
            SCOPED_TRACE(fmt::format("{}, {}", text_of(size), word));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout& layout, DrawingModel& model) {
                    Tool const tool(*find_tool_kind(all_methods().tools, word));
                    model.perform(ChooseTool { tool });
                    for (int i = 1; i <= 12; ++i)
                        model.add_card({ fmt::format("A card of a long name, {}", i), tool });
                    layout.bench().cards_are_shown = true;
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
    Tool const tool(*find_tool_kind(all_methods().tools, "sketch"));
    model.perform(ChooseTool { tool });
    auto const second = ready_cards(tool)[1].tool;
    std::vector<Moment> moments { { { 0, 0 } }, { { 0, 0 } } };
    for (float y = 300; y < 420; y += 20) { // Wherever the second card of the first row is.
        moments.push_back({ { 230, y } });
        moments.push_back({ { 230, y }, true });
        moments.push_back({ { 230, y } });
    }
    work({ 1600, 900 }, moments, model,
         [](Layout& layout) { layout.bench().cards_are_shown = true; });
    EXPECT_EQ(model.state().hand, second);
}

// Wherever on the glyph a drag begins, it sets the rule as it moves and once when it ends, if it
// began on a handle, and draws nothing on the pad below.
TEST_F(LayoutTest, DragsTheHandlesOfTheRule)
{
    DrawingModel model;
    model.perform(ChooseTool { Tool(*find_tool_kind(all_methods().tools, "sketch")) });
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

} // namespace tractus
