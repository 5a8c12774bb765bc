#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Makes the decoder for a device from its report descriptor. Fails with a user error with the
// reason if the device is no pen or sends reports in its maker's own format, and as the device's
// fault if its descriptor is broken.
Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const&);

} // namespace tractus::drivers
