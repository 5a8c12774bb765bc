#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"

#include <deque>

namespace tractus::window {

// Lets the pen operate the window's controls. Its tip is ImGui's pointer, and its touch is the
// mouse button wherever the station reports that the pen presses instead of drawing. While the pen
// is in range, the system's mouse is ignored, as the system may also treat the pen as a mouse.
class PenPointer {
public:
    static constexpr float kLongPress_s = 0.6f;
    // Maximum movement of a touch that rests. It is measured in space, so that raising the surface
    // with a resting pen counts as drawing.
    static constexpr float kRestRadius_mm = 1.5f;

    // Reads the pen's events and sets ImGui's mouse; `area` is that of the last frame. Call this
    // once per frame, before ImGui::NewFrame().
    void feed(view::WindowState const& state, PenArea const& area, float step_s);

    // True while the pen is ImGui's pointer.
    bool leads() const { return leads_; }
    ImVec2 place_px() const { return place_px_; }

    // True if pen events are left for which another frame is needed.
    bool has_more() const { return !path_.empty(); }

    // True if the pen's barrel button was pressed in this frame, or if its touch has rested for
    // kLongPress_s.
    bool requests_tool_ring() const { return requests_tool_ring_; }
    bool has_released_barrel() const { return has_released_barrel_; }

private:
    void take_next();
    void watch_rest(float step_s);

    std::deque<view::PenView> path_; // Pen events that have not been passed to ImGui yet.
    view::PenView pen_;              // State of the pen that was last passed to ImGui.
    bool leads_ = false;
    ImVec2 place_px_ { 0, 0 };
    bool requests_tool_ring_ = false;
    bool has_released_barrel_ = false;
    Vec3f touch_mm_ = Vec3f::Zero(); // Position of the tip when the current touch began.
    float rest_s_ = 0;   // Seconds for which the current touch has rested where it began.
    bool rests_ = false; // True while the current touch is still resting where it began.
};

} // namespace tractus::window
