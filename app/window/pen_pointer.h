#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"

#include <deque>

namespace tractus::window {

// Lets the pen that the station reads work the window: its tip is the pointer, its touch the mouse
// button, as far as the station says that it presses. While it is in range the window system's own
// mouse counts for nothing, since that system takes the pen for one.
class PenPointer {
public:
    static constexpr float kLongPress_s = 0.6f;
    static constexpr float kAtRest_mm = 1.5f; // In space: a hand that lifts the surface draws.

    // Takes what the pen did and puts ImGui's mouse where it points, by the area that the last
    // frame showed. Once in each frame, before ImGui's begins.
    void feed(view::WindowState const& state, PenArea const& area, float step_s);

    // The pen is the pointer now.
    bool leads() const { return leads_; }
    ImVec2 place_px() const { return place_px_; }

    // It did more than one frame can show: another frame is due.
    bool has_more() const { return !path_.empty(); }

    // In this frame: its button went down, or it began to touch and has rested since.
    bool asks_for_ring() const { return asks_for_ring_; }
    bool has_let_barrel_go() const { return has_let_barrel_go_; }

private:
    void take_next();
    void watch_rest(float step_s);

    std::deque<view::PenView> path_; // Not shown to ImGui yet.
    view::PenView pen_;              // As ImGui has it.
    bool leads_ = false;
    ImVec2 place_px_ { 0, 0 };
    bool asks_for_ring_ = false;
    bool has_let_barrel_go_ = false;
    Vec3f touch_mm_ = Vec3f::Zero(); // Where the touch under way began.
    float rest_s_ = 0;               // How long it has rested there.
    bool rests_ = false;             // It never left that place.
};

} // namespace tractus::window
