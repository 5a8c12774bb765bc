#pragma once

#include "app/calibration/calibration_controller.h"
#include "app/calibration/calibration_view.h"
#include "app/devices/live_devices.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::controllers {

struct CalibrationPanelControllerOptions {
    calibration::CalibrationController::Options controller {};
    // Heights to propose, in this order; empty: proposed_heights_mm().
    std::vector<double> heights_mm {};
    std::string date {}; // Date for the calibration's record.
    std::function<Timestamp()> now {};

    // Writes the outcome to the rig's file. Returns a message for the user about what was written,
    // or the error.
    std::function<Result<std::string>(calibration::CalibrationOutcome const&)> keep {};
};

// Controller of the calibration page, which shows the live reading, the captures and, from the
// second capture on, the fit and its plots. Resting the pen on the tablet captures the proposed
// height. A procedure starts from the results of earlier procedures. Nothing is written until the
// user asks for it.
class CalibrationPanelController final : public calibration::CalibrationModel {
public:
    // Fails like CalibrationController::create().
    static Result<CalibrationPanelController> create(std::vector<drivers::DeviceInfo> devices,
                                                     CalibrationPanelControllerOptions options);

    // push() receives a report of a device; advance() evaluates the reports received so far.
    void push(devices::LiveReport const& report);
    void advance();

    calibration::CalibrationView const& view() const override { return view_; }
    void perform(calibration::CalibrationCommand const& command) override;

    // Returns the rig if the user has saved one since the last call.
    std::optional<calib::Rig> take_kept_rig() { return std::exchange(kept_, std::nullopt); }

private:
    CalibrationPanelController(std::vector<drivers::DeviceInfo> devices,
                               CalibrationPanelControllerOptions options,
                               calibration::CalibrationController controller);

    void perform_kind(calibration::ChooseProcedure const& command);
    void perform_kind(calibration::ProposeHeight const& command)
    {
        view_.proposed_mm = command.height_mm;
    }
    void perform_kind(calibration::CaptureHeight const& command);
    void perform_kind(calibration::UndoCapture const&);
    void perform_kind(calibration::BeginMovement const&);
    void perform_kind(calibration::EndMovement const&);
    void perform_kind(calibration::KeepRig const&);
    void perform_kind(calibration::PressWithPen const&);

    void capture(Timestamp time, double ruler_mm);
    // Returns false if the command was refused; the view then gives the reason.
    bool command(Timestamp time, std::string const& words);
    void fit();
    void propose();
    void show_reading();
    void refuse(std::string const& why);

    std::vector<drivers::DeviceInfo> devices_;
    CalibrationPanelControllerOptions options_;
    calibration::CalibrationController controller_;
    // Outcome computed from the captures so far.
    std::optional<calibration::CalibrationOutcome> outcome_;
    std::optional<calib::Rig> kept_;
    bool was_capturing_ = false;
    bool is_moving_ = false;
    calibration::CalibrationView view_;
};

} // namespace tractus::controllers
