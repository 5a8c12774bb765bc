#pragma once

#include "app/view/window_model.h"
#include "app/window/hand_input.h"
#include "app/window/pen_area.h"

#include <span>

namespace tractus::window {

// Uses the mouse as a pen over a part of the window, when there is no tablet.
class MouseHand {
public:
    // Handles what the mouse did since the last frame over ImGui's last item, which shows `area`. A
    // touch that begins there draws until it ends, wherever the mouse goes.
    void hold(view::WindowModel& model, PenArea const& area, std::span<MouseMoment const> path);

    // Call instead of hold() when no item shows the pen's area.
    void let_go(view::WindowModel& model);

private:
    bool is_in_range_ = false;
    bool is_down_ = false; // True if the button is down and was pressed over the area.
};

} // namespace tractus::window
