#include "app/live/calibration_window.h"

#include <utility>

namespace tractus {

Result<CalibrationWindow> CalibrationWindow::create(LiveDevices devices,
                                                    CalibrationBenchOptions options)
{
    auto bench = TRY(CalibrationBench::create(devices.infos(), std::move(options)));
    return CalibrationWindow(std::move(devices), std::move(bench));
}

CalibrationWindow::CalibrationWindow(LiveDevices devices, CalibrationBench bench)
    : devices_(std::move(devices))
    , bench_(std::move(bench))
{
    state_.playing = true;
}

void CalibrationWindow::advance(Duration)
{
    devices_.take(reports_);
    for (auto const& report : reports_)
        bench_.push(report);
    bench_.advance();
}

} // namespace tractus
