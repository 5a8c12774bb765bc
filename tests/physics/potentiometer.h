#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace tractus::physics {

// The physics of a rig as a second pair of eyes sees it: written from how strings, potentiometers
// and converters behave, not from `sim` nor from `calib`, whose assumptions it is there to doubt.

using Dice = std::mt19937_64;

double uniform(Dice& dice, double low, double high);
double normal(Dice& dice, double deviation);

// Faults that a rig may have. It has none by default.
struct Faults {
    double pulley_radius_mm = 0;   // The string leaves a pulley, not a point.
    double nonlinearity = 0;       // Greatest deviation of the track, in parts of its length.
    double loading = 0;            // Resistance of the track over that of the converter's input.
    double noise_counts = 0.5;     // White.
    double hum_counts = 0;         // Hum at 50 Hz.
    double drift_counts_per_s = 0; // Drift of the supply, as it warms up.
    double hysteresis_mm = 0;      // The string's end lags behind the table by half of it.
};

struct Geometry {
    double offset_mm = 100;
    double base_mm = 100;
    double track_mm = 600;    // String that the whole potentiometer takes up.
    double first_part = 0.08; // Share of the track that is used up at height zero.
    int full_scale = 4095;
    bool is_spool_above = false; // base_mm is then how far the spool is above height zero.
    bool counts_down = false;    // The potentiometer's outer wires are swapped.
};

class Potentiometer {
public:
    Potentiometer(Geometry const& geometry, Faults const& faults, Dice& dice);

    // The string slips by so much, and from now on the wiper stands so much farther; the table's
    // zero comes to lie so much higher over the pulley.
    void befall(double slip_mm, double move_mm);

    // The converter's input, in counts that are not rounded yet, with the table at rest.
    double counts(double height_mm) const;

    // One reading; `direction` is +1 where the table came from below, -1 from above, 0 from
    // nowhere.
    int read(double height_mm, double direction, double seconds, Dice& dice) const;

private:
    double length(double height_mm) const;
    double bend(double part) const;

    Geometry geometry_;
    Faults faults_;
    double shortest_mm_ = 0; // The string, with the wiper at the track's first part.
    double hum_phase_ = 0;
    std::array<double, 4> waves_ {};
    double wave_scale_ = 0;
};

} // namespace tractus::physics
