#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "engine/base/result.h"

#include <memory>
#include <string>

namespace tractus::drivers {

// The reports of the hidraw device at `info.location`, both ways, through hidapi. Output reports
// are those of a device without report ids. Other readers, the kernel's own driver among them, go
// on as before. Input reports longer than a RawReport holds are left out and counted.
//
// Fails, as the user's fault, if the device is not there or may not be read and written, which the
// rules in drivers/70-tractus.rules permit.
Result<std::unique_ptr<PacketLink>> open_hid_link(DeviceInfo info);

// The feature reports of such a device, as a link for drivers that ask: to write a single byte, a
// report's id, asks for that report, which is read next; to write more sets the report that begins
// so. Writing waits for the device's answer, so there is never anything to wait for when reading.
// Fails like open_hid_link().
Result<std::unique_ptr<PacketLink>> open_hid_feature_link(DeviceInfo info);

// Why a hidraw node cannot be opened, in a sentence for its user: not permitted, busy, gone.
// `error` is what open() has left in errno.
std::string cannot_open_hidraw(DeviceInfo const& info, int error);

} // namespace tractus::drivers
