#pragma once

#include "app/window/calibration_view.h"

#include <imgui.h>

namespace tractus {

// The calibration in the window: procedures, the live reading, captures with their residuals, and
// the plots. Draws itself into the current ImGui window's room; what a person asks for goes to the
// model at once.
class CalibrationPanel {
public:
    // `title_font` is theme::apply()'s; `scale` the display's.
    CalibrationPanel(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
    {
    }

    void show(CalibrationModel& model);

private:
    void show_procedures(CalibrationModel& model);
    void show_reading(CalibrationView const& view);
    void show_controls(CalibrationModel& model);
    void show_captures(CalibrationView const& view);

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
    float height_mm_ = 0;       // In the entry.
    double proposed_mm_ = -1e9; // What the entry was last set to.
};

// One plot at ImGui's cursor.
void show_plot(Plot const& plot, ImVec2 const& size_px);

} // namespace tractus
