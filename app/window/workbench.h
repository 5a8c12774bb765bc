#pragma once

#include "app/view/window_model.h"
#include "app/window/display.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::window {

// What a drag means that turns no tool.
enum class ViewDrag { Turn, Move };

// How much nearer one step of the wheel goes.
constexpr double kZoomStep = 1.12;

// How the window is set up to work with: what is not the document's, nor the station's.
struct Workbench {
    enum class Shown {
        All, // Pad, skeleton and plant side by side.
        Pad, // Each of the others fills the window, or the tablet's own display.
        Skeleton,
        Plant,
        Collection, // Variations to pick from.
    };
    Shown shown = Shown::All;
    // Nothing is seen but what grows, over all of the window, while the pen draws as on the pad.
    bool is_on_stage = false;

    // The view tool is in hand: the pointer turns and zooms views and draws nothing.
    bool turns_views = false;
    ViewDrag drag = ViewDrag::Turn;
    // What the view tool's buttons ask of the views that are seen; the layout does it and takes it
    // back.
    double zoom_wished = 1;
    bool whole_is_wished = false;
    // From where the skeleton is seen, and selected from.
    scene::SelectionAngle angle { .shape = scene::SelectionAngle::Shape::AsBent };
    // What the menu beside the views is open at.
    enum class MenuPage {
        None, // It is closed.
        Plant,
        Keep,
        Devices,
        Window,
    };
    MenuPage menu = MenuPage::None;
    MenuPage last_menu = MenuPage::Plant; // What it opens at.
    // The displays that the window may fill, and the one that it does fill, as of the last frame.
    std::vector<Display> displays {};
    std::optional<std::size_t> filled_display {};
    // Whether it shall; without a display the tablet's own, else the one that it is on. Done and
    // taken back before the next frame.
    struct FullScreen {
        bool is_on = true;
        std::optional<std::size_t> display {};
    };
    std::optional<FullScreen> full_screen_wished {};
    bool keys_are_listed = false;
    // The menu and the drawing of the tool in hand lie on the left, where a left hand reaches them
    // without hiding the views; the scale of heights, which is only read, on the right.
    bool is_left_handed = false;
    // The number, among those of the tool in hand, that its panel is open for.
    std::optional<std::size_t> asked_number {};
    bool cards_are_shown = false; // Of the kind in hand.
    // What a panel with keys asks for a name of, and the name that it has.
    struct AskedName {
        enum class Of { Drawing, Copy, Card } of = Of::Drawing;
        std::string now {};

        bool operator==(AskedName const& other) const = default;
    };
    std::optional<AskedName> asked_name {};
    // Shows the tool in hand as a drawing, if its kind has one.
    bool glyph_is_shown = true;
    bool drawn_glyph_is_shown = false; // Likewise for what was drawn with it.
    bool glyph_is_seen = false;        // In the last frame: it needs room, too.
    // The tool in hand as a slider or a handle that moves will have made it.
    std::optional<tools::Tool> adjusted {};
    bool wants_to_close = false;

    // The tool in hand, as it is being adjusted.
    tools::Tool const& hand(view::WindowState const& state) const;
    // Gives the tool in hand other numbers; what was drawn with it follows.
    void adjust(view::WindowModel& model, tools::Tool tool, view::ChangeGrowth::Slider slider);

    // Takes a tool in hand, and shows the view that it works in if one fills the window.
    void choose(view::WindowModel& model, tools::Tool tool);
    // What tools mean that are chosen anew: the station's and those chosen here, the latest last.
    std::vector<tools::Tool> remembered(view::WindowState const& state) const;
    void choose_view_tool();
    void show_next();        // The next of Shown.
    void turn_full_screen(); // On if it is off.
    void enter_stage();      // In full screen.
    bool will_fill_display() const;
    // One of the panels above the bar, in place of another one.
    void ask_number(std::size_t number);
    void show_cards();
    void ask_name(AskedName name); // In place of the menu, too.
    void close_panels();
    void open_menu(MenuPage page);
    void close_menu() { menu = MenuPage::None; }
    bool menu_is_open() const { return menu != MenuPage::None; }

    // The area in which pen or mouse selects is the skeleton's; else it draws on the pad's.
    static bool selects(view::WindowState const& state)
    {
        return state.hand.kind().surface == tools::Surface::Skeleton;
    }
    bool is_shown(Shown one) const { return shown == one || shown == Shown::All; }

    // The pointer draws, or selects, in the area that is shown for it.
    bool draws(view::WindowState const& state) const;

private:
    void remember(tools::Tool const& tool);

    std::vector<tools::Tool> chosen_methods_ {}; // The last of each kind that belongs to a method.
};

} // namespace tractus::window
