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
    std::vector<double> heights_mm {}; // To propose, in this order; empty: those of the procedure.
    std::string date {};               // Today's.
    std::function<Timestamp()> now {};

    // Writes what was found out; what it did, or why it could not.
    std::function<Result<std::string>(calibration::CalibrationOutcome const&)> keep {};
};

// Contents of the window while a person calibrates devices: the reading, the captures and, from the
// second one on, the fit and its plots. A pen that rests on the tablet captures the proposed
// height. What one procedure found out is what the next begins with; nothing is written before the
// person asks for it.
class CalibrationPanelController final : public calibration::CalibrationModel {
public:
    // Fails as CalibrationController::create does.
    static Result<CalibrationPanelController> create(std::vector<drivers::DeviceInfo> devices,
                                                     CalibrationPanelControllerOptions options);

    // Takes what a device has sent; advance() draws conclusions from all that has come.
    void push(devices::LiveReport const& report);
    void advance();

    calibration::CalibrationView const& view() const override { return view_; }
    void perform(calibration::CalibrationCommand const& command) override;

    // The rig that was kept since the last call.
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
    void perform_kind(calibration::CaptureAt const& command);
    void perform_kind(calibration::UndoCapture const&);
    void perform_kind(calibration::BeginMovement const&);
    void perform_kind(calibration::EndMovement const&);
    void perform_kind(calibration::KeepRig const&);
    void perform_kind(calibration::PressWithPen const&);

    void capture(Timestamp time, double ruler_mm);
    bool command(Timestamp time,
                 std::string const& words); // False if it was refused; the view says why.
    void fit();
    void propose();
    void show_reading();
    void refuse(std::string const& why);

    std::vector<drivers::DeviceInfo> devices_;
    CalibrationPanelControllerOptions options_;
    calibration::CalibrationController controller_;
    std::optional<calibration::CalibrationOutcome> outcome_; // Outcome of everything so far.
    std::optional<calib::Rig> kept_;
    bool was_capturing_ = false;
    bool is_moving_ = false;
    calibration::CalibrationView view_;
};

} // namespace tractus::controllers
