#include "app/devices/live_diagnosis.h"

#include "app/diagnosis/diagnose.h"
#include "app/diagnosis/system_facts.h"

#include <utility>

namespace tractus::devices {

LiveDiagnosis::LiveDiagnosis(LiveDevices const& devices, Timestamp now)
    : begin_(now)
    , now_(now)
    , machine_findings_(diagnosis::diagnose_system(diagnosis::gather_system_facts()))
{
    for (auto const& info : devices.infos())
        monitors_.emplace_back(info);
}

void LiveDiagnosis::pass_time(Timestamp now)
{
    now_ = now;
    for (auto& monitor : monitors_)
        monitor.pass_time(now);
}

std::vector<diagnosis::DeviceReading> LiveDiagnosis::readings() const
{
    std::vector<diagnosis::DeviceReading> readings;
    for (auto const& monitor : monitors_)
        readings.push_back(monitor.reading());
    return readings;
}

std::vector<diagnosis::Finding> LiveDiagnosis::findings() const
{
    auto findings = machine_findings_;
    auto const all = readings();
    for (auto const& reading : all)
        for (auto& finding : diagnosis::diagnose_device(reading, now_ - begin_))
            findings.push_back(std::move(finding));
    for (auto& finding : diagnosis::diagnose_together(all))
        findings.push_back(std::move(finding));
    return findings;
}

} // namespace tractus::devices
