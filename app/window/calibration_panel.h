#pragma once

#include "app/calibration/calibration_view.h"

#include <imgui.h>

namespace tractus::window {

// The calibration page of the window: procedures, live reading, captures with their residuals, and
// plots. It draws into the current ImGui window and passes input to the model at once.
class CalibrationPanel {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
    CalibrationPanel(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
    {
    }

    // Shows the panel. If `may_go_back`, it has a button for returning to drawing. Returns true if
    // this button was pressed.
    bool show(calibration::CalibrationModel& model, bool may_go_back);

private:
    bool show_procedures(calibration::CalibrationModel& model, bool may_go_back);
    void show_reading(calibration::CalibrationView const& view);
    void show_controls(calibration::CalibrationModel& model);
    void show_height(calibration::CalibrationModel& model) const;
    void show_captures(calibration::CalibrationView const& view);

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
};

// Draws a plot at ImGui's cursor, in an area of `size_px`.
void show_plot(calibration::Plot const& plot, ImVec2 const& size_px);

} // namespace tractus::window
