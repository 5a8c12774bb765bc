#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Makes the decoder for a device from its report descriptor. Fails with a user error with the
// reason if the device is not a pen or sends reports in its maker's own format, and with a device
// error if its descriptor is broken.
Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const&);

} // namespace tractus::drivers
