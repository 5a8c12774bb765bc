#include "app/window/pen_pointer.h"

#include "app/window/imgui_mouse.h"

#include <cfloat>

namespace tractus::window {

void PenPointer::feed(view::WindowState const& state, PenArea const& area, float step_s)
{
    requests_tool_ring_ = false;
    has_released_barrel_ = false;
    if (!state.has_pen()) {
        leads_ = false;
        return;
    }
    path_.insert(path_.end(), state.pen_path.begin(), state.pen_path.end());
    take_next();
    watch_rest(step_s);
    bool const led = leads_;
    leads_ = pen_.in_range;
    if (!leads_ && !led)
        return;
    place_px_ = area.to_px(pen_.tip_mm.head<2>().cast<double>());
    // While the pen draws, it does not point at controls.
    bool const points = leads_ && (!pen_.touching || pen_.pressing);
    put_imgui_mouse(points ? place_px_ : ImVec2(-FLT_MAX, -FLT_MAX),
                    leads_ && pen_.touching && pen_.pressing);
}

// Reads pen events up to the next change that ImGui must see for at least one frame.
void PenPointer::take_next()
{
    while (!path_.empty()) {
        auto const next = path_.front();
        path_.pop_front();
        bool const begins = next.touching && !pen_.touching;
        bool const ends = !next.touching && pen_.touching;
        requests_tool_ring_ |= next.barrel && !pen_.barrel;
        has_released_barrel_ |= !next.barrel && pen_.barrel;
        bool const changes = begins || ends || next.barrel != pen_.barrel;
        pen_ = next;
        if (begins) {
            touch_mm_ = pen_.tip_mm;
            rest_s_ = 0;
            rests_ = true;
        }
        if (changes)
            return;
    }
}

void PenPointer::watch_rest(float step_s)
{
    bool const draws = pen_.touching && !pen_.pressing;
    rests_ = rests_ && draws && (pen_.tip_mm - touch_mm_).norm() <= kRestRadius_mm;
    if (!rests_)
        return;
    rest_s_ += step_s;
    if (rest_s_ < kLongPress_s)
        return;
    rests_ = false;
    requests_tool_ring_ = true;
    // The state that the station will report as soon as it knows of the press.
    pen_.pressing = true;
}

} // namespace tractus::window
