#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <memory>
#include <optional>

namespace tractus::drivers {

// Makes a decoder for the pen that the device's report descriptor describes (PenLayout). `size_mm`
// is the active area from our table. If the descriptor gives no plausible size, this one is used,
// or else the size known to the kernel; `width_to_height` gives the proportions if neither exists.
//
// Fails with a user error with the reason if the device is no pen or sends reports in its
// maker's own format, and with a device error if its descriptor is broken.
Result<std::unique_ptr<PenDecoder>>
make_descriptor_decoder(DeviceInfo const& info, std::optional<Vec2> const& size_mm = std::nullopt,
                        std::optional<double> width_to_height = std::nullopt);

} // namespace tractus::drivers
