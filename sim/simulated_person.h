#pragma once

#include "calib/height_capture.h"
#include "sim/rig_geometry.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::sim {

// A person who calibrates: sets the carriage to heights with a ruler, none too exactly, and says
// what the ruler shows.

struct Slip {
    std::size_t capture = 0;
    double wrong_by_mm = 20; // Error of what the person says, upwards.
};

struct PersonOptions {
    std::uint64_t seed = 1;
    double ruler_error_mm = 0.3; // Standard deviation.
    std::optional<Slip> slip {};
    double noise_counts = 1;    // Noise of the sensor, before rounding.
    std::size_t readings = 500; // Per capture.
};

// A height that a person means to set, and the one really set.
struct SetHeight {
    double true_mm = 0; // Where the carriage is.
    double said_mm = 0; // Height that the person says.
};

// The heights that a person sets who aims at `aimed_mm`.
std::vector<SetHeight> set_heights(std::span<double const> aimed_mm, PersonOptions const& options);

// The captures that come of them, from the sensor of a rig: noise and rounding included, without
// the detour through reports.
std::vector<calib::HeightCapture> simulate_captures(RigGeometry const& geometry,
                                                    std::span<double const> aimed_mm,
                                                    PersonOptions const& options);

} // namespace tractus::sim
