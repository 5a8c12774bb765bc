#pragma once

#include "app/view/window_model.h"
#include "app/window/display.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::window {

// What a drag in a view does.
enum class ViewDrag { Turn, Move };

// Zoom factor per step of the wheel.
constexpr double kZoomStep = 1.12;

// State of the user interface that belongs neither to the document nor to the station.
struct Workspace {
    enum class Shown {
        All, // Pad, skeleton and plant side by side, with the strokes below the pad if they fit.
        // Pad and the values below fill the window, or the tablet's own display, with one view.
        Pad,
        Strokes, // The curves that were drawn, with their names.
        Skeleton,
        Plant,
        Collection, // Shows variations of the plant to choose from.
    };
    Shown shown = Shown::All;
    // The view that a drawing begins with. No value: the pad for a pen tablet, otherwise all views.
    std::optional<Shown> shown_first {};
    // Stage view: only the growing plant is shown, over the whole window; the pen draws as on the
    // pad.
    bool is_on_stage = false;

    // The view tool is selected: the pointer turns and zooms views and draws nothing.
    bool turns_views = false;
    ViewDrag drag = ViewDrag::Turn;
    // Requests by the view tool's buttons to the visible views; the layout fulfils and resets them.
    double requested_zoom = 1;
    bool is_whole_requested = false;
    // Viewing direction of the skeleton, also used for selecting branches.
    scene::SelectionAngle angle { .shape = scene::SelectionAngle::Shape::AsBent };
    // The open page of the menu.
    enum class MenuPage {
        None, // The menu is closed.
        Plant,
        Keep,
        Devices,
        Window,
    };
    MenuPage menu = MenuPage::None;
    MenuPage last_menu = MenuPage::Plant; // The page at which the menu opens.
    // The displays that the window may fill, and the index of the one that it fills, as of the last
    // frame.
    std::vector<Display> displays {};
    std::optional<std::size_t> filled_display {};
    // A request to enter or leave full screen. Without a display: the tablet's own, otherwise the
    // one that the window is on. Fulfilled and reset before the next frame.
    struct FullScreen {
        bool is_on = true;
        std::optional<std::size_t> display {};
    };
    std::optional<FullScreen> requested_full_screen {};
    bool keys_are_listed = false;
    // Left-handed layout: the menu and the current tool's drawing are on the left, where a left
    // hand reaches them without covering the views; the height scale, which is only read, is on the
    // right.
    bool is_left_handed = false;
    // Index of the number of the current tool whose panel is open.
    std::optional<std::size_t> edited_number {};
    bool cards_are_shown = false; // True if the cards of the current tool's kind are shown.
    // What the name panel is asking a name for, and its current name.
    struct NameRequest {
        enum class Of { Drawing, Copy, Card } of = Of::Drawing;
        std::string now {};

        bool operator==(NameRequest const& other) const = default;
    };
    std::optional<NameRequest> name_request {};
    // Shows the gizmo of the current tool, if its kind has one.
    bool gizmo_is_shown = true;
    bool drawn_gizmo_is_shown = false; // Shows the gizmo of what was last drawn with the tool.
    bool gizmo_is_seen = false; // A gizmo was shown in the last frame and needs room in this one.
    // The current tool with the value that a moving slider or handle has now.
    std::optional<tools::Tool> adjusted {};
    bool is_close_requested = false;

    // The current tool, as it is being adjusted.
    tools::Tool const& hand(view::WindowState const& state) const;
    // Changes the numbers of the current tool; what was drawn with it is adapted
    // (ToolKind::follow).
    void adjust(view::WindowModel& model, tools::Tool tool, view::ChangeGrowth::Slider slider);

    // Selects a tool, and shows the view that it works in if another one fills the window.
    void choose(view::WindowModel& model, tools::Tool tool);
    // The tools whose settings are restored when a tool is selected again: the station's and those
    // chosen here, the latest last.
    std::vector<tools::Tool> remembered(view::WindowState const& state) const;
    void choose_view_tool();
    void show_next();        // Shows the view after the current one in the order of Shown.
    void turn_full_screen(); // Toggles full screen.
    void enter_stage();      // Shows the stage in full screen.
    bool will_fill_display() const;
    // Opens a panel above the bar that asks for a number or name, and closes any other panel.
    void ask_number(std::size_t number);
    void show_cards();
    void ask_name(NameRequest name); // Opens the name panel and closes the menu.
    void close_panels();
    void open_menu(MenuPage page);
    void close_menu() { menu = MenuPage::None; }
    bool menu_is_open() const { return menu != MenuPage::None; }

    // True if the pen or mouse selects in the skeleton's area; false if it draws on the pad.
    static bool selects(view::WindowState const& state)
    {
        return state.hand.kind().surface == tools::Surface::Skeleton;
    }
    bool is_shown(Shown one) const { return shown == one || shown == Shown::All; }

    // True if the pointer draws or selects in the area shown for it.
    bool draws(view::WindowState const& state) const;

private:
    void remember(tools::Tool const& tool);

    std::vector<tools::Tool> chosen_methods_ {}; // The last tool of each kind that belongs to a
                                                 // method.
};

// The words of Workspace::Shown for the command line, in its order: "all", "pad" and so on.
std::span<std::string_view const> shown_words();

// Parses one of shown_words(). No value for another word.
std::optional<Workspace::Shown> parse_shown(std::string_view word);

} // namespace tractus::window
