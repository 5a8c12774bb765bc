#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <memory>
#include <optional>

namespace tractus::drivers {

// Decodes what the device's report descriptor describes (PenLayout). `size_mm` is the active area
// as our table knows it; it, or else the size that the kernel knows, is believed where the
// descriptor tells none that makes sense; `width_to_height` are its proportions where no more is
// known.
//
// Fails, as the user's fault, with the reason if the device is no pen or sends reports of its
// maker's own making, and as the device's fault if its descriptor is broken.
Result<std::unique_ptr<PenDecoder>>
make_descriptor_decoder(DeviceInfo const& info, std::optional<Vec2> const& size_mm = std::nullopt,
                        std::optional<double> width_to_height = std::nullopt);

} // namespace tractus::drivers
