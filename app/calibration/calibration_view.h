#pragma once

#include "app/calibration/calibration_controller.h"
#include "app/calibration/plot.h"
#include "engine/base/time.h"

#include <string>
#include <variant>
#include <vector>

namespace tractus::calibration {

// Everything that the calibration's panel shows at one moment.
struct CalibrationView {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
    std::string reading {}; // The sensor's, with noise and whether it rests.
    bool is_on_rail = false;
    bool may_capture = false; // The surface rests, and nothing is being captured.
    bool is_capturing = false;
    bool is_moving = false; // True between begin and end of a movement.
    std::vector<calib::HeightCapture> captures {};
    std::vector<double> residuals_mm {}; // One per capture, or empty before the first fit.
    std::vector<std::size_t> slipped {}; // Captures that the fit leaves out.
    double proposed_mm = 0;              // The height to go to next, and to capture there.
    std::string message {};              // Says what to do, or what was refused and why.
    bool is_refusal = false;             // The message is one.
    std::string report {};               // Report of the fit so far; empty before the first.
    std::vector<Plot> plots {};          // Plots of the fit so far.
    bool may_keep = false;               // There is something to write to the rig's file.
};

// Requests of a person in the panel.
struct ChooseProcedure {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
};
struct ProposeHeight {
    double height_mm = 0; // The height that is captured next, by CaptureAt or by the pen's rest.
};
struct CaptureAt {
    double ruler_mm = 0;
};
struct UndoCapture { };
struct BeginMovement { };
struct EndMovement { };
struct KeepRig { }; // Writes the rig's file.
struct PressWithPen {
}; // The pen's touch under way presses what the panel shows, and means no more.
using CalibrationCommand = std::variant<ChooseProcedure, ProposeHeight, CaptureAt, UndoCapture,
                                        BeginMovement, EndMovement, KeepRig, PressWithPen>;

// Where the panel's contents come from. Called from the window's thread only.
class CalibrationModel {
public:
    virtual ~CalibrationModel() = default;

    // The present state; valid until the next perform() or until the window's model advances.
    virtual CalibrationView const& view() const = 0;

    virtual void perform(CalibrationCommand const& command) = 0;
};

} // namespace tractus::calibration
