#pragma once

#include "app/controllers/calibration_panel_controller.h"
#include "app/devices/live_devices.h"
#include "app/view/window_model.h"
#include "engine/base/result.h"

#include <vector>

namespace tractus {

// A window that is there to calibrate, and for nothing else.
class CalibrationWindow final : public WindowModel {
public:
    // Fails as CalibrationPanelController::create does.
    static Result<CalibrationWindow> create(LiveDevices devices,
                                            CalibrationPanelControllerOptions options);

    void advance(Duration real_step) override;
    WindowState const& state() const override { return state_; }
    void perform(WindowCommand const&) override { }
    CalibrationModel* calibration() override { return &panel_; }

private:
    CalibrationWindow(LiveDevices devices, CalibrationPanelController panel);

    LiveDevices devices_;
    CalibrationPanelController panel_;
    std::vector<LiveReport> reports_; // Kept for its memory.
    WindowState state_;               // Nothing but the calibration is shown.
};

} // namespace tractus
