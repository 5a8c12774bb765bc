#pragma once

#include "app/controllers/calibration_panel_controller.h"
#include "app/devices/live_devices.h"
#include "app/view/window_model.h"
#include "engine/base/result.h"

#include <vector>

namespace tractus::controllers {

// A window in which devices can only be calibrated.
class CalibrationWindow final : public view::WindowModel {
public:
    // Fails like CalibrationPanelController::create().
    static Result<CalibrationWindow> create(devices::LiveDevices devices,
                                            CalibrationPanelControllerOptions options);

    void advance(Duration real_step) override;
    view::WindowState const& state() const override { return state_; }
    void perform(view::WindowCommand const&) override { }
    calibration::CalibrationModel* calibration() override { return &panel_; }

private:
    CalibrationWindow(devices::LiveDevices devices, CalibrationPanelController panel);

    devices::LiveDevices devices_;
    CalibrationPanelController panel_;
    // New reports of the devices. A member, so that its memory is reused.
    std::vector<devices::LiveReport> reports_;
    view::WindowState state_; // State of the window; only its calibration is used.
};

} // namespace tractus::controllers
