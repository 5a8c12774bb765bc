#pragma once

#include "app/devices/live_devices.h"
#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"

#include <vector>

namespace tractus::devices {

// Diagnosis of the devices for a person who draws with them: their newest raw values, how regularly
// they send, and what is the matter with them or with the machine.
class LiveDiagnosis {
public:
    // Looks at the machine, which takes some milliseconds, and begins to listen.
    LiveDiagnosis(LiveDevices const& devices, Timestamp now);

    void push(LiveReport const& report) { monitors_[report.device].push(report.report); }
    void pass_time(Timestamp now);

    std::vector<diagnosis::DeviceReading> readings() const; // One for each device.
    std::vector<diagnosis::Finding> findings() const;       // Empty if nothing is the matter.

private:
    Timestamp begin_;
    Timestamp now_;
    std::vector<diagnosis::DeviceMonitor> monitors_;
    std::vector<diagnosis::Finding> of_machine_;
};

} // namespace tractus::devices
