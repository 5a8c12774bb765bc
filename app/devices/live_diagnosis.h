#pragma once

#include "app/devices/live_devices.h"
#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"

#include <vector>

namespace tractus::devices {

// Diagnosis of the devices while the user draws: their latest raw values, the regularity of their
// reports, and problems of the devices or the computer.
class LiveDiagnosis {
public:
    // Examines the computer, which takes some milliseconds, and begins to collect statistics.
    LiveDiagnosis(LiveDevices const& devices, Timestamp now);

    void push(LiveReport const& report) { monitors_[report.device].push(report.report); }
    void pass_time(Timestamp now);

    // Statistics of the devices, one element per device.
    std::vector<diagnosis::DeviceReading> readings() const;
    std::vector<diagnosis::Finding> findings() const; // Problems found; empty if there are none.

private:
    Timestamp begin_;
    Timestamp now_;
    std::vector<diagnosis::DeviceMonitor> monitors_;
    std::vector<diagnosis::Finding> machine_findings_;
};

} // namespace tractus::devices
