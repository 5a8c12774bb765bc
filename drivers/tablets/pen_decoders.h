#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// The decoder for a device, by its report descriptor. Fails, as the user's fault, with the reason
// if the device is no pen or sends reports of its maker's own making, and as the device's fault if
// its descriptor is broken.
Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const&);

} // namespace tractus::drivers
