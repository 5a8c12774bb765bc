#pragma once

#include "drivers/reports/device_info.h"

#include <string>

namespace tractus::drivers {

// Role of a device in the station.
enum class DeviceKind {
    Pen,    // make_pen_decoder takes it.
    Height, // make_height_decoder takes it.
    Other,  // Neither does.
};

struct DeviceDescription {
    DeviceKind kind = DeviceKind::Other;
    // "pen tablet, 152.0 x 95.0 mm", "height sensor, 0 to 4095"; for the others the reason why they
    // are neither, as a sentence.
    std::string text {};
};

// Tells from the report descriptor alone.
DeviceDescription describe_device(DeviceInfo const&);

} // namespace tractus::drivers
