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

// Effect of dragging in a view: the camera turns around what is shown, or moves sideways.
enum class ViewDrag { Turn, Move };

// Zoom factor for a step of the mouse wheel.
constexpr double kZoomStep = 1.12;

// State of the user interface, which belongs neither to the document nor to the station.
struct Workspace {
    enum class Shown {
        // Pad, skeleton and plant side by side, and the strokes below the pad if there is room.
        All,
        // From here on: a single view that fills the window, or the tablet's own display.
        Pad,
        Strokes, // The curves that the user has drawn, with their names.
        Skeleton,
        Plant,
        Collection, // Variations of the plant, from which the user can choose.
    };
    Shown shown = Shown::All;
    // View with which a drawing begins. No value: the pad if there is a pen tablet, otherwise all
    // views.
    std::optional<Shown> shown_first {};
    // True in the stage view: the window shows only the growing plant, and the pen draws as on the
    // pad.
    bool is_on_stage = false;

    // True if the view tool is selected: the pointer turns and zooms views, and does not draw.
    bool turns_views = false;
    ViewDrag drag = ViewDrag::Turn;
    // Requests of the view tool's buttons for the visible views. The layout carries them out and
    // resets them.
    double requested_zoom = 1;
    bool is_whole_requested = false;
    // Direction from which the skeleton is viewed; it is also the direction for selecting branches.
    scene::SelectionAngle angle { .shape = scene::SelectionAngle::Shape::AsBent };
    // Page of the menu that is open.
    enum class MenuPage {
        None, // The menu is closed.
        Plant,
        Keep,
        Devices,
        Window,
    };
    MenuPage menu = MenuPage::None;
    MenuPage last_menu = MenuPage::Plant; // Page with which the menu opens.
    // The displays that the window can fill, and the index of the one that it fills, both as of the
    // last frame.
    std::vector<Display> displays {};
    std::optional<std::size_t> filled_display {};
    // A request to enter or leave full screen. Without `display`, the window fills the tablet's own
    // display, otherwise the display on which it is. Carried out and reset before the next frame.
    struct FullScreen {
        bool is_on = true;
        std::optional<std::size_t> display {};
    };
    std::optional<FullScreen> requested_full_screen {};
    bool keys_are_listed = false;
    // True for the left-handed layout. The menu and the current tool's gizmo are then on the left,
    // where a left hand reaches them without covering the views. The height scale, which is only
    // read, is on the right.
    bool is_left_handed = false;
    // Index of the current tool's number whose panel is open; no value if none is.
    std::optional<std::size_t> edited_number {};
    bool cards_are_shown = false; // True if the cards for the current kind of tool are shown.
    // What the name panel asks a name for, and its present name.
    struct NameRequest {
        enum class Of { Drawing, Copy, Card } of = Of::Drawing;
        std::string now {};

        bool operator==(NameRequest const& other) const = default;
    };
    std::optional<NameRequest> name_request {};
    // True: the gizmo of the current tool is shown, if its kind has one.
    bool gizmo_is_shown = true;
    // True: the gizmo of what was last drawn with the tool is shown.
    bool drawn_gizmo_is_shown = false;
    // True if a gizmo was shown in the last frame and needs space in this one.
    bool gizmo_is_seen = false;
    // The current tool with the value to which the user is moving a slider or handle.
    std::optional<tools::Tool> adjusted {};
    bool is_close_requested = false;

    // Returns the current tool, with the changes that the user is making.
    tools::Tool const& hand(view::WindowState const& state) const;
    // Sets the numbers of the current tool. What was drawn with the tool is adapted
    // (ToolKind::follow).
    void adjust(view::WindowModel& model, tools::Tool tool, view::ChangeGrowth::Slider slider);

    // Selects a tool. If another view than the tool's own fills the window, shows the tool's view.
    void choose(view::WindowModel& model, tools::Tool tool);
    // Returns the tools whose options are restored when they are selected again, the latest last:
    // those of the station and those selected here.
    std::vector<tools::Tool> remembered(view::WindowState const& state) const;
    void choose_view_tool();
    void show_next();        // Shows the next view in the order of Shown.
    void turn_full_screen(); // Enters full screen, or leaves it.
    void enter_stage();      // Shows the stage view in full screen.
    bool will_fill_display() const;
    // These open a panel above the bar, for a number, cards or a name, and close any other panel.
    void ask_number(std::size_t number);
    void show_cards();
    void ask_name(NameRequest name); // Opens the name panel, and closes the menu.
    void close_panels();
    void open_menu(MenuPage page);
    void close_menu() { menu = MenuPage::None; }
    bool menu_is_open() const { return menu != MenuPage::None; }

    // True if the pen or mouse selects branches in the skeleton's view; false if it draws on the
    // pad.
    static bool selects(view::WindowState const& state)
    {
        return state.hand.kind().surface == tools::Surface::Skeleton;
    }
    bool is_shown(Shown one) const { return shown == one || shown == Shown::All; }

    // True if the pointer draws or selects in the area that is shown for it.
    bool draws(view::WindowState const& state) const;

private:
    void remember(tools::Tool const& tool);

    // Tool that was last selected of each kind that belongs to a method.
    std::vector<tools::Tool> chosen_methods_ {};
};

// Returns the words for Workspace::Shown on the command line, in its order: "all", "pad" and so on.
std::span<std::string_view const> shown_words();

// Parses a word of shown_words(). No value for any other word.
std::optional<Workspace::Shown> parse_shown(std::string_view word);

} // namespace tractus::window
