#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Makes the decoder for a height sensor, chosen only by the device's description, so that a log of
// any sensor replays as it was recorded.
//
// Fails with a user error if the device is not a height sensor, and with a device error if its
// description is invalid.
Result<std::unique_ptr<HeightDecoder>> make_height_decoder(DeviceInfo const&);

} // namespace tractus::drivers
