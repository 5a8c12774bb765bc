#include "app/controllers/calibration_window.h"

#include <utility>

namespace tractus::controllers {

Result<CalibrationWindow> CalibrationWindow::create(devices::LiveDevices devices,
                                                    CalibrationPanelControllerOptions options)
{
    auto panel = TRY(CalibrationPanelController::create(devices.infos(), std::move(options)));
    return CalibrationWindow(std::move(devices), std::move(panel));
}

CalibrationWindow::CalibrationWindow(devices::LiveDevices devices, CalibrationPanelController panel)
    : devices_(std::move(devices))
    , panel_(std::move(panel))
{
    state_.playing = true;
}

void CalibrationWindow::advance(Duration)
{
    devices_.take(reports_);
    for (auto const& report : reports_)
        panel_.push(report);
    panel_.advance();
}

} // namespace tractus::controllers
