#pragma once

#include "engine/base/time.h"
#include "sim/hand.h"
#include "sim/height_faults.h"
#include "sim/rig_geometry.h"
#include "sim/simulated_device.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// Protocol of the simulated height sensor, a string potentiometer on an analogue-to-digital
// converter. HidSlider: an absolute Generic Desktop Slider (HID Usage Tables, page 0x01, usage
// 0x36) whose logical range is the converter's; a report has four bytes: report id 1, the counts,
// least significant first, and a zero. Frames: the station's own kind of sensor, which sends
// several readings per frame with times of its own clock (sim/height_sensor_frames.h).
enum class HeightWire { HidSlider, Frames };

struct HeightOptions {
    std::uint64_t seed = 1;
    DeviceTiming timing {
        .period = std::chrono::milliseconds(2), // A rate of 500 Hz.
        .latency = std::chrono::milliseconds(3),
        .jitter = std::chrono::microseconds(200),
    };
    HeightWire wire = HeightWire::HidSlider;
    int samples_per_frame = 5; // Number of readings per frame; unused for HidSlider.
    // Parts per million by which the sensor's clock is slow; unused for HidSlider.
    double clock_drift_ppm = 0;
    double noise_counts = 1; // Standard deviation of the readings' noise, before rounding.
    std::vector<SimulatedHeightFault> faults {}; // Faults; their times are times of measurement.
};

struct SimulatedHeight {
    SimulatedDevice device;
    // Mean latency of the sensor's decoded samples, as a calibration would measure it.
    Duration latency {};
};

// Simulates the height sensor of a rig while a hand draws. Readings beyond the converter's range
// are clamped to it. Full scale is at most 16 bits.
SimulatedHeight simulate_height(Hand const& hand, RigGeometry const& geometry,
                                HeightOptions const& options);

// Description of the HID slider, and its report for a reading, for uses without a Hand.
drivers::DeviceInfo simulated_slider_info(std::int32_t full_scale_counts);
drivers::RawReport simulated_slider_report(std::int32_t counts, Timestamp received);

} // namespace tractus::sim
