#pragma once

#include "drivers/reports/device_info.h"

#include <string>

namespace tractus::drivers {

// Role of a device in the station.
enum class DeviceKind {
    Pen,    // Accepted by make_pen_decoder().
    Height, // Accepted by make_height_decoder().
    Other,  // Accepted by neither decoder.
};

struct DeviceDescription {
    DeviceKind kind = DeviceKind::Other;
    // For a pen or height sensor a summary, such as "pen tablet, 152.0 x 95.0 mm" or "height
    // sensor, 0 to 4095". For any other device, a sentence that says why it is neither.
    std::string text {};
};

// Classifies a device from its ids and report descriptor, without reading reports.
DeviceDescription describe_device(DeviceInfo const&);

} // namespace tractus::drivers
