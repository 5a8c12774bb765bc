#pragma once

#include "drivers/reports/device_info.h"
#include "tests/drivers/bytes.h"

namespace tractus::drivers {

// A pen tablet for tests: 200 x 100 mm, 100 counts per millimetre. The bytes of its pen report:
//   02      id
//   ..      bits: 0 tip, 1 and 2 barrel, 3 invert, 4 eraser, 5 in range
//   .. ..   x, 0 to 20000
//   .. ..   y, 0 to 10000
//   .. ..   pressure, 0 to 2047
//   ..      tilt to the right, degrees
//   ..      tilt towards the user, degrees
// Its other report, 3, is the state of its battery.
inline DeviceInfo simple_pen()
{
    return { .name = "Simple Pen",
             .physical_path = "usb-0000:00:14.0-1/input0",
             .vendor_id = 0x1209,
             .product_id = 0x0002,
             .report_descriptor
             = bytes("05 0d 09 02 a1 01 85 02 09 20 a1 00"
                     "09 42 09 44 09 5a 09 3c 09 45 09 32 15 00 25 01 75 01 95 06 81 02"
                     "95 02 81 03"
                     "05 01 09 30 26 20 4e 35 00 46 c8 00 65 11 55 0f 75 10 95 01 81 02"
                     "09 31 26 10 27 46 64 00 81 02"
                     "05 0d 09 30 26 ff 07 45 00 65 00 55 00 81 02"
                     "09 3d 09 3e 15 a6 25 5a 35 a6 45 5a 65 14 75 08 95 02 81 02"
                     "c0 c0"
                     "05 84 09 04 a1 01 85 03 05 85 09 65 15 00 25 64 75 08 95 01 81 02 c0") };
}

// The height sensor of firmware-notes/height-sensor.md: report 1, a slider from 0 to 4095.
inline DeviceInfo simple_height_sensor()
{
    return { .name = "Height Sensor",
             .vendor_id = 0x1209,
             .product_id = 0x0001,
             .report_descriptor
             = bytes("05 01 09 08 a1 01 85 01 09 36 15 00 26 ff 0f 75 10 95 01 81 02 c0") };
}

} // namespace tractus::drivers
