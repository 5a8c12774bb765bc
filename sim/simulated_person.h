#pragma once

#include "calib/height_capture.h"
#include "sim/rig_geometry.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::sim {

// A mistake in a calibration: the person states a wrong height for one capture.
struct Slip {
    std::size_t capture = 0;
    double wrong_by_mm = 20; // Error of the stated height, upwards.
};

// A person who calibrates: sets the carriage to heights with a ruler, with limited accuracy, and
// states what the ruler shows.
struct PersonOptions {
    std::uint64_t seed = 1;
    double ruler_error_mm = 0.3; // Standard deviation of a set height from the stated one.
    std::optional<Slip> slip {};
    double noise_counts = 1;    // Standard deviation of the sensor's noise, before rounding.
    std::size_t readings = 500; // Number of readings per capture.
};

// A height that a person sets: the true one and the stated one.
struct SetHeight {
    double true_mm = 0;   // Height of the carriage.
    double stated_mm = 0; // Height stated by the person.
};

// Returns the heights set by a person who aims at `aimed_mm`.
std::vector<SetHeight> set_heights(std::span<double const> aimed_mm, PersonOptions const& options);

// Returns the captures of the sensor's readings at these heights, including noise and rounding.
// Reports are not simulated.
std::vector<calib::HeightCapture> simulate_captures(RigGeometry const& geometry,
                                                    std::span<double const> aimed_mm,
                                                    PersonOptions const& options);

} // namespace tractus::sim
