#pragma once

#include "app/calibration/calibration_view.h"

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

    // True if a person wants back to drawing, which `may_go_back` offers.
    bool show(CalibrationModel& model, bool may_go_back);

private:
    bool show_procedures(CalibrationModel& model, bool may_go_back);
    void show_reading(CalibrationView const& view);
    void show_controls(CalibrationModel& model);
    void show_height(CalibrationModel& model) const;
    void show_captures(CalibrationView const& view);

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
};

// One plot at ImGui's cursor.
void show_plot(Plot const& plot, ImVec2 const& size_px);

} // namespace tractus
