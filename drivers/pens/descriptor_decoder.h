#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <memory>
#include <optional>

namespace tractus::drivers {

// Makes a decoder for the pen that the device's report descriptor describes (PenLayout). The active
// area's size comes from the descriptor if it is plausible there, otherwise from `size_mm`, the
// size in the table of tablets, otherwise from the kernel. Without any of these, `width_to_height`
// gives its proportions.
//
// Fails with a user error that gives the reason if the device is not a pen or sends reports in its
// maker's own format, and with a device error if its descriptor is broken.
Result<std::unique_ptr<PenDecoder>>
make_descriptor_decoder(DeviceInfo const& info, std::optional<Vec2> const& size_mm = std::nullopt,
                        std::optional<double> width_to_height = std::nullopt);

} // namespace tractus::drivers
