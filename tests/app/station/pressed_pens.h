#pragma once

#include "drivers/reports/device_info.h"
#include "tests/app/simple_rig.h"
#include "tests/drivers/bytes.h"

#include <cstddef>
#include <ostream>
#include <vector>

namespace tractus {

// State of a pen on a tablet of 200 x 100 mm.
struct PenState {
    double x_mm = 0; // Distance from the tablet's left edge.
    double y_mm = 0; // Distance from the tablet's far edge.
    bool touching = false;
    int pressure = 1000; // Used only while the pen touches the tablet.
};

// A report format of tablets: a device, and a function that encodes a pen's state as a report.
struct PenFormat {
    char const* name;
    drivers::DeviceInfo (*device)();
    std::vector<std::byte> (*report)(PenState const& pen);
};

inline std::ostream& operator<<(std::ostream& out, PenFormat const& format)
{
    return out << format.name;
}

// Returns the format of a pen that is described as in the HID standard.
inline PenFormat standard_pen()
{
    return { "standard", drivers::simple_pen, [](PenState const& pen) {
                std::vector<std::byte> report { std::byte { 2 },
                                                pen.touching ? std::byte { 0x21 }
                                                             : std::byte { 0x20 } };
                append_u16(report, static_cast<int>(100 * pen.x_mm));
                append_u16(report, static_cast<int>(100 * pen.y_mm));
                append_u16(report, pen.touching ? pen.pressure : 0);
                append_u16(report, 0); // Both tilts are 0.
                return report;
            } };
}

// Returns the format of a tablet that its driver has not switched yet: a mouse with tip pressure.
inline PenFormat mouse_mode_pen()
{
    auto const device = [] {
        return drivers::DeviceInfo {
            .name = "Mouse",
            .report_descriptor = drivers::bytes(
                "05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 "
                "02 95 05 81 01 05 01 09 30 09 31 26 ff 7f 95 02 75 10 81 02 05 0d 09 30 26 ff 1f "
                "95 01 81 02 c0 c0")
        };
    };
    auto const report = [](PenState const& pen) {
        std::vector<std::byte> bytes { std::byte { 1 },
                                       pen.touching ? std::byte { 1 } : std::byte { 0 } };
        append_u16(bytes, static_cast<int>(pen.x_mm / 200 * 32767));
        append_u16(bytes, static_cast<int>(pen.y_mm / 100 * 32767));
        append_u16(bytes, pen.touching ? pen.pressure : 0);
        return bytes;
    };
    return { "mouse mode", device, report };
}

// Returns the format of a Huion HS610, whose coordinates are 50,800 x 31,750 counts, 200 per mm.
inline PenFormat huion_v2_pen()
{
    auto const device = [] {
        return drivers::DeviceInfo {
            .name = "HUION Huion Tablet",
            .vendor_id = 0x256c,
            .product_id = 0x006d,
            .report_descriptor
            = drivers::bytes("06 00 ff 09 01 a1 01 85 08 75 58 95 01 09 01 81 02 c0"),
            .strings = { { 201, "HUION_T194_180726" } },
        };
    };
    auto const report = [](PenState const& pen) {
        std::vector<std::byte> bytes { std::byte { 8 },
                                       pen.touching ? std::byte { 0x81 } : std::byte { 0x80 } };
        append_u16(bytes, static_cast<int>(200 * pen.x_mm));
        append_u16(bytes, static_cast<int>(200 * pen.y_mm));
        append_u16(bytes, pen.touching ? pen.pressure : 0);
        append_u16(bytes, 0); // The upper bytes of both coordinates are 0.
        append_u16(bytes, 0); // Both tilts are 0.
        return bytes;
    };
    return { "Huion version 2", device, report };
}

} // namespace tractus
