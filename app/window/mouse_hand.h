#pragma once

#include "app/view/window_model.h"
#include "app/window/hand_input.h"
#include "app/window/pen_area.h"

#include <span>

namespace tractus::window {

// Uses the mouse as the pen over a part of the window, if there is no tablet.
class MouseHand {
public:
    // Processes the mouse's events since the last frame. ImGui's last item shows the surface, at
    // `area`. A touch that begins on this item draws until it ends, wherever the mouse goes.
    void hold(view::WindowModel& model, PenArea const& area, std::span<MouseMoment const> path);

    // Call this instead of hold() if no item shows the surface.
    void let_go(view::WindowModel& model);

private:
    bool is_in_range_ = false;
    bool is_down_ = false; // True if the button was pressed over the surface and is still down.
};

} // namespace tractus::window
