#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// The decoder of a height sensor, chosen by what is known of the device alone, so that a log of
// any sensor replays as it was recorded.
//
// Fails, as the user's fault, if the device is no height sensor, and as the device's if what it
// says of itself is broken.
Result<std::unique_ptr<HeightDecoder>> make_height_decoder(DeviceInfo const&);

} // namespace tractus::drivers
