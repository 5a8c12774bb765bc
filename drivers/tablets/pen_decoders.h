#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Makes the decoder for a pen: by the table of tablets if the device is in it, otherwise by its
// report descriptor. Fails with a user error that gives the reason if the device is not a pen or
// sends reports in an unknown format, and with a device error if its descriptor is broken.
Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const&);

} // namespace tractus::drivers
