#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "engine/base/result.h"

#include <memory>
#include <string>

namespace tractus::drivers {

// Opens the hidraw device at `info.location` for input and output reports, through hidapi. Output
// reports have no report id. Other readers, including the kernel's driver, are not affected. Input
// reports longer than a RawReport are dropped and counted.
//
// Fails with a user error if the device is missing or lacks the permissions that
// drivers/70-tractus.rules grants.
Result<std::unique_ptr<PacketLink>> open_hid_link(DeviceInfo info);

// Opens the feature reports of a hidraw device as a link. Writing a single byte, a report id,
// requests that report, which is read next; writing more sets the report with that id. Writing
// blocks until the device answers, so reading never waits. Fails like open_hid_link().
Result<std::unique_ptr<PacketLink>> open_hid_feature_link(DeviceInfo info);

// Explains to the user why a hidraw node cannot be opened. `error` is the errno of open().
std::string cannot_open_hidraw(DeviceInfo const& info, int error);

} // namespace tractus::drivers
