#pragma once

#include "app/calibration/calibration_controller.h"
#include "app/calibration/plot.h"
#include "engine/base/time.h"

#include <string>
#include <variant>
#include <vector>

namespace tractus::calibration {

// Everything that the calibration panel shows at a given moment.
struct CalibrationView {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
    std::string reading {}; // Text with the sensor's reading, its noise, and whether it rests.
    bool is_on_rail = false;
    bool may_capture = false; // True if the surface rests and no capture is in progress.
    bool is_capturing = false;
    bool is_moving = false; // True between the beginning and the end of a movement.
    std::vector<calib::HeightCapture> captures {};
    std::vector<double> residuals_mm {}; // Residual of each capture; empty before the first fit.
    std::vector<std::size_t> slipped {}; // Indices of captures that the fit leaves out.
    double proposed_mm = 0;              // Height that the panel proposes to set and capture next.
    std::string message {};              // Tells the user what to do, or what was refused and why.
    bool is_refusal = false;             // True if `message` explains a refusal.
    std::string report {};               // Report of the fit so far; empty before the first fit.
    std::vector<Plot> plots {};          // Plots of the fit so far.
    bool may_keep = false;               // True if there is a result to save in the rig's file.
};

// Commands of the user in the panel.
struct ChooseProcedure {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
};
struct ProposeHeight {
    double height_mm = 0; // Height to be captured by CaptureHeight or by resting the pen.
};
struct CaptureHeight {
    double ruler_mm = 0;
};
struct UndoCapture { };
struct BeginMovement { };
struct EndMovement { };
struct KeepRig { }; // Saves the rig's file.
struct PressWithPen {
}; // The pen's current touch presses a control of the panel and has no effect on the calibration.
using CalibrationCommand = std::variant<ChooseProcedure, ProposeHeight, CaptureHeight, UndoCapture,
                                        BeginMovement, EndMovement, KeepRig, PressWithPen>;

// Supplies the calibration panel's contents. For use on the window's thread only.
class CalibrationModel {
public:
    virtual ~CalibrationModel() = default;

    // Returns the current state, valid until the next perform() or the window model's next
    // advance().
    virtual CalibrationView const& view() const = 0;

    virtual void perform(CalibrationCommand const& command) = 0;
};

} // namespace tractus::calibration
