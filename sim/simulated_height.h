#pragma once

#include "engine/base/time.h"
#include "sim/hand.h"
#include "sim/height_faults.h"
#include "sim/rig_geometry.h"
#include "sim/simulated_device.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// The height sensor: a string potentiometer on an analog-to-digital converter that speaks HID, as
// an absolute Generic Desktop Slider (HID Usage Tables, page 0x01, usage 0x36) whose logical range
// is the converter's. A report has four bytes: report id 1, the counts, least significant first,
// and a spare zero. Or on the station's own kind of sensor, which sends frames of several readings
// with the times of its own clock (sim/height_sensor_frames.h).
enum class HeightWire { HidSlider, Frames };

struct HeightOptions {
    std::uint64_t seed = 1;
    DeviceTiming timing {
        .period = std::chrono::milliseconds(2), // 500 Hz
        .latency = std::chrono::milliseconds(3),
        .jitter = std::chrono::microseconds(200),
    };
    HeightWire wire = HeightWire::HidSlider;
    int samples_per_frame = 5;                   // Number for frames.
    double clock_drift_ppm = 0;                  // How much the clock that frames tell is slow.
    double noise_counts = 1;                     // Standard deviation, before rounding.
    std::vector<SimulatedHeightFault> faults {}; // Faults by the time of measuring.
};

struct SimulatedHeight {
    SimulatedDevice device;
    // How late its samples are in the mean, once decoded: what a calibration would measure.
    Duration latency {};
};

// Simulates what the height sensor of a rig sends while a hand draws. Readings beyond the
// converter's range are clamped to it. Full scale is at most 16 bits.
SimulatedHeight simulate_height(Hand const& hand, RigGeometry const& geometry,
                                HeightOptions const& options);

// The HID slider, moved by somebody who is no Hand: what it is, and what it sends for a reading.
drivers::DeviceInfo simulated_slider_info(std::int32_t full_scale_counts);
drivers::RawReport simulated_slider_report(std::int32_t counts, Timestamp received);

} // namespace tractus::sim
