#pragma once

#include "engine/base/time.h"
#include "engine/base/vectors.h"
#include "sim/hand.h"
#include "sim/rig_geometry.h"
#include "sim/simulated_device.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// A pen tablet with reports as in the HID standard, described by its own report descriptor
// (HID 1.11, section 6.2.2; HID Usage Tables, page 0x0D): 100 counts per millimetre, 8,192 levels
// of pressure, tilt in whole degrees. A report has ten bytes, least significant first:
//
//     0     report id, 2
//     1     bit 0 tip, 1 barrel button, 2 second barrel button, 3 eraser, 4 invert, 5 in range
//     2, 3  x from the left edge
//     4, 5  y from the far edge
//     6, 7  pressure, 13 bits
//     8, 9  tilt towards +x and towards the user, signed
//
// The eraser end hovers with "invert", and touches with "invert" and "eraser".

struct TabletOptions {
    std::uint64_t seed = 1;
    DeviceTiming timing {
        .period = std::chrono::milliseconds(5), // A rate of 200 Hz.
        .latency = std::chrono::milliseconds(8),
        .jitter = std::chrono::microseconds(400),
    };
    // Standard deviation of the tilt's noise in degrees, before rounding.
    double tilt_noise_deg = 0;
};

// The pen's true tip at the time of a measurement.
struct TrueTip {
    Timestamp time {};
    Vec3 position_mm = Vec3::Zero(); // Position of the tip, world frame.
    bool touching = false;
};

struct SimulatedTablet {
    SimulatedDevice device;
    std::vector<TrueTip> truth; // True tips, one for each report.
};

// Simulates the tablet of a rig while a hand draws on it. The reported position is that below the
// pen's coil. When the pen goes out of range, one report says so, and no report follows until it
// returns. A pen off the active area is out of range. No side of the tablet may be longer than 655
// mm.
SimulatedTablet simulate_tablet(Hand const& hand, RigGeometry const& geometry,
                                TabletOptions const& options);

// State of a pen for reports without a Hand; the functions below give the device's description and
// its report for a state. The position is on the tablet's active area, in the tablet frame.
struct TabletPen {
    Vec2 place_mm = Vec2::Zero();
    bool in_range = false;
    bool touching = false;
    double pressure = 0; // Pressure from 0 to 1.
};
drivers::DeviceInfo simulated_tablet_info(Vec2 const& size_mm);
drivers::RawReport simulated_tablet_report(TabletPen const& pen, Vec2 const& size_mm,
                                           Timestamp received);

} // namespace tractus::sim
