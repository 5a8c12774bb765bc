#include "tests/app/window/layout_fixture.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::window {

using namespace layout_tests;
using Of = Workspace::NameRequest::Of;

namespace {

constexpr std::size_t kButtonCount = 2 + 40 + 3;

// Returns the buttons of the name panel, row by row: confirm and Close, four rows of ten keys, and
// three other keys.
std::vector<DrawnFrame::Button> name_buttons(DrawnFrame const& drawn)
{
    std::vector<DrawnFrame::Button> buttons;
    for (auto const& button : drawn.buttons)
        if (button.whole.panel.find("name") != std::string::npos)
            buttons.push_back(button);
    std::sort(buttons.begin(), buttons.end(), [](auto const& one, auto const& other) {
        bool const is_row = std::abs(one.whole.top - other.whole.top) < 4;
        return is_row ? one.whole.left < other.whole.left : one.whole.top < other.whole.top;
    });
    return buttons;
}

} // namespace

TEST_F(LayoutTest, ShowsKeysForANameInTheWindow)
{
    for (auto const& size : sizes())
        for (auto const of : { Of::Drawing, Of::Copy, Of::Card }) {
            SCOPED_TRACE(fmt::format("{}, {}", text_of(size), static_cast<int>(of)));
            show(
                { size.width, size.height }, size.scale,
                [&](Layout& layout, DrawingModel&) {
                    layout.workspace().ask_name({ of, "A name of some length for what was drawn" });
                },
                [&](DrawnFrame const& drawn, ImVec2 const& size_px) {
                    auto const buttons = name_buttons(drawn);
                    EXPECT_EQ(buttons.size(), kButtonCount);
                    for (std::size_t i = 0; i < buttons.size(); ++i) {
                        auto const& box = buttons[i].visible;
                        EXPECT_GE(box.left, -1.5f) << text_of(box);
                        EXPECT_GE(box.top, -1.5f) << text_of(box);
                        EXPECT_LE(box.right, size_px.x + 1.5f) << text_of(box);
                        EXPECT_LE(box.bottom, size_px.y + 1.5f) << text_of(box);
                        for (std::size_t k = 0; k < i; ++k)
                            EXPECT_FALSE(overlap(box, buttons[k].visible)) << text_of(box);
                    }
                });
        }
}

// Finds the keys where they were drawn, and presses them. The first letter must be a capital.
TEST_F(LayoutTest, NamesTheDrawingWithKeysOnTheWindow)
{
    ImVec2 const size { 1600, 900 };
    std::vector<DrawnFrame::Button> buttons;
    auto const ask = [](Layout& layout) { layout.workspace().ask_name({ Of::Drawing, "" }); };
    show(
        size, 1, [&](Layout& layout, DrawingModel&) { ask(layout); },
        [&](DrawnFrame const& drawn, ImVec2 const&) { buttons = name_buttons(drawn); });
    ASSERT_EQ(buttons.size(), kButtonCount);
    constexpr std::size_t kA = 2 + 20;
    constexpr std::size_t kS = kA + 1;
    constexpr std::size_t kH = kA + 5;
    constexpr std::size_t kSpace = 2 + 40 + 1;
    constexpr std::size_t kDelete = kSpace + 1;
    constexpr std::size_t kTwo = 2 + 1;
    constexpr std::size_t kDone = 0;
    DrawingModel model;
    model.name("Shrub");
    std::vector<Moment> moments { { { 0, 0 } }, { { 0, 0 } } };
    for (auto const key : { kA, kS, kH, kH, kDelete, kSpace, kTwo, kDone }) {
        auto const& box = buttons[key].whole;
        ImVec2 const middle { (box.left + box.right) / 2, (box.top + box.bottom) / 2 };
        for (bool const is_down : { false, true, false })
            moments.push_back({ middle, is_down });
    }
    // If the panel were closed, the key C would choose a tool.
    moments[1].input.presses.push_back({ 'C' });
    work(size, moments, model, ask, [](Layout& layout) {
        EXPECT_FALSE(layout.workspace().name_request) << "the panel closes when it is done";
    });
    ASSERT_EQ(model.given_names.size(), 1u);
    EXPECT_EQ(model.given_names.front(), "Ash 2");
    EXPECT_EQ(model.touches, 0u) << "nothing is drawn below the panel";
}

// The name is typed on the keyboard, in several frames.
TEST_F(LayoutTest, TypesANameInThePlaceOfTheOldOneAndConfirmsWithEnter)
{
    auto const name_by = [&](std::vector<Moment> const& moments, bool is_closed) {
        DrawingModel model;
        model.name("Shrub");
        work(
            { 1600, 900 }, moments, model,
            [](Layout& layout) {
                layout.workspace().ask_name({ Of::Drawing, "Shrub" });
            },
            [&](Layout& layout) { EXPECT_EQ(!layout.workspace().name_request, is_closed); });
        EXPECT_EQ(model.surface_mm, 0) << "letters move no surface";
        return model.given_names;
    };
    auto const frame
        = [](std::string typed, std::vector<char> const& pressed = {}, std::string held = {}) {
              Moment moment { .place_px = { 0, 0 }, .typed = std::move(typed) };
              for (auto const key : pressed)
                  moment.input.presses.push_back({ key });
              moment.input.held = std::move(held);
              return moment;
          };
    using Names = std::vector<std::string>;
    auto const enter = frame("", { KeyPress::kEnter });
    EXPECT_EQ(
        name_by({ frame(""), frame("w", { 'W' }, "W"), frame("s", { 'S' }, "S"), enter }, true),
        Names { "ws" });
    EXPECT_EQ(name_by({ frame(""), enter }, true), Names { "Shrub" }) << "the old one stands";
    EXPECT_EQ(
        name_by({ frame(""), frame("", { KeyPress::kBackspace }), frame("Yew"), enter }, true),
        Names { "Yew" })
        << "all of the old one goes at once";
    EXPECT_EQ(
        name_by({ frame(""), frame("Yews"), frame("", { KeyPress::kBackspace }), enter }, true),
        Names { "Yew" });
    EXPECT_EQ(name_by({ frame(""), frame("Yew"), frame("", { KeyPress::kEscape }) }, true),
              Names {})
        << "Esc gives up";
    EXPECT_EQ(name_by({ frame(""), frame("", { 'Q', 'N', 'V' }, "WS") }, false), Names {})
        << "no key does anything else meanwhile";
}

TEST_F(LayoutTest, MovesTheSurfaceByKeysWhereNothingIsTyped)
{
    DrawingModel model;
    Moment up { .place_px = { 0, 0 } };
    up.input.held = "W";
    work({ 1600, 900 }, { up, up }, model);
    EXPECT_GT(model.surface_mm, 0);
}

} // namespace tractus::window
