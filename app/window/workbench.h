#pragma once

#include "app/window/window_model.h"

namespace tractus {

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

    // The view tool is in hand: the pointer turns and zooms views and draws nothing.
    bool turns_views = false;
    // From where the skeleton is seen, and selected from.
    SelectionAngle angle {};
    bool menu_is_open = false;
    bool keys_are_listed = false;
    bool wants_to_close = false;

    // Takes a tool in hand, and shows the view that it works in if one fills the window.
    void choose(WindowModel& model, Tool tool);
    void choose_view_tool();
    void show_next(); // The next of Shown.

    // The area in which pen or mouse selects is the skeleton's; else it draws on the pad's.
    static bool selects(WindowState const& state) { return state.hand.kind == Tool::Kind::Select; }
    bool is_shown(Shown one) const { return shown == one || shown == Shown::All; }

    // The pointer draws, or selects, in the area that is shown for it.
    bool draws(WindowState const& state) const;
};

} // namespace tractus
