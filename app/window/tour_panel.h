#pragma once

#include "app/window/controls.h"

#include <imgui.h>

namespace tractus::window {

// A strip above the bar that shows the step of the tour: what to do and how, and buttons with which
// the user skips the step or ends the tour.
class TourPanel {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
    TourPanel(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
    {
    }

    // Returns the strip's height in the last frame, in pixels; 0 if it was not shown.
    float height_px() const { return height_px_; }

    // Shows the strip above `bar` and returns its rectangle. Only allowed if there is a tour;
    // otherwise call hide() in this frame.
    WindowPart show(view::WindowModel& model, Controls const& controls, WindowPart const& bar);
    void hide() { height_px_ = 0; }

private:
    void show_words(view::TourView const& tour, float width) const;

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
    float height_px_ = 0;
};

} // namespace tractus::window
