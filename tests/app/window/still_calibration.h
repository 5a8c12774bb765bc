#pragma once

#include "app/calibration/calibration_view.h"
#include "app/calibration/height_plots.h"
#include "sim/simulated_person.h"

namespace tractus::window {

// A finished, constant calibration of the heights of a string potentiometer. It has seven captures,
// one of which slipped.
class StillCalibration : public calibration::CalibrationModel {
public:
    StillCalibration()
    {
        double const heights[] { 0, 60, 200, 400, 300, 120, 20 };
        view_.captures = sim::simulate_captures(
            {}, heights, { .slip = sim::Slip { .capture = 2, .wrong_by_mm = 20 } });
        auto const fit = calib::fit_height(view_.captures).value();
        view_.residuals_mm = fit.residuals_mm;
        view_.slipped = fit.slipped;
        view_.plots = calibration::height_plots(fit, view_.captures, 4095);
        view_.reading = "2034.0 counts, noise 1.0, at rest";
        view_.message = "Press Keep to write the rig's file, or capture more heights.";
        view_.report = fit.reason;
        view_.may_keep = true;
    }

    calibration::CalibrationView const& view() const override { return view_; }
    void perform(calibration::CalibrationCommand const&) override { ++commands; }

    int commands = 0;

private:
    calibration::CalibrationView view_;
};

} // namespace tractus::window
