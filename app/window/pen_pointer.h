#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"

#include <deque>

namespace tractus::window {

// Lets the pen operate the window's controls: its tip is the pointer and its touch the mouse
// button, wherever the station says that it presses rather than draws. While the pen is in range
// the system's mouse is ignored, because the system may also treat the pen as a mouse.
class PenPointer {
public:
    static constexpr float kLongPress_s = 0.6f;
    // A touch counts as resting below this movement, measured in space, so that raising the surface
    // with a resting pen counts as drawing.
    static constexpr float kRestRadius_mm = 1.5f;

    // Reads the pen's events and places ImGui's mouse, using the area of the last frame. Call once
    // per frame, before ImGui's NewFrame.
    void feed(view::WindowState const& state, PenArea const& area, float step_s);

    // True while the pen is the pointer.
    bool leads() const { return leads_; }
    ImVec2 place_px() const { return place_px_; }

    // True if pen events are left that one frame cannot show: another frame is due.
    bool has_more() const { return !path_.empty(); }

    // True if the pen's barrel button was pressed in this frame, or its touch has rested long
    // enough.
    bool requests_tool_ring() const { return requests_tool_ring_; }
    bool has_released_barrel() const { return has_released_barrel_; }

private:
    void take_next();
    void watch_rest(float step_s);

    std::deque<view::PenView> path_; // Pen events that were not passed to ImGui yet.
    view::PenView pen_;              // The pen's state that was last passed to ImGui.
    bool leads_ = false;
    ImVec2 place_px_ { 0, 0 };
    bool requests_tool_ring_ = false;
    bool has_released_barrel_ = false;
    Vec3f touch_mm_ = Vec3f::Zero(); // Place where the current touch began.
    float rest_s_ = 0;   // Seconds for which the current touch has stayed where it began.
    bool rests_ = false; // True while the current touch has not left the place where it began.
};

} // namespace tractus::window
