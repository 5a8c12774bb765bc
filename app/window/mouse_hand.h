#pragma once

#include "app/view/window_model.h"
#include "app/window/hand_input.h"
#include "app/window/pen_area.h"

#include <span>

namespace tractus::window {

// Holds the mouse as a pen over a part of the window, where there is no tablet.
class MouseHand {
public:
    // What the mouse did since the last frame, over ImGui's last item, which shows `area`. A touch
    // that begins there is the pen's until it ends, wherever it goes.
    void hold(view::WindowModel& model, PenArea const& area, std::span<MouseMoment const> path);

    // Over nothing of the kind.
    void let_go(view::WindowModel& model);

private:
    bool is_in_range_ = false;
    bool is_down_ = false; // And began on the area.
};

} // namespace tractus::window
