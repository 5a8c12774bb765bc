#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace tractus::physics {

// An independent model of a rig's physics: written from the behaviour of strings, potentiometers
// and converters, without the assumptions of `sim` and `calib`, which it tests.

using Dice = std::mt19937_64;

double uniform(Dice& dice, double low, double high);
double normal(Dice& dice, double deviation);

// Faults of a rig. By default there are none.
struct Faults {
    double pulley_radius_mm = 0; // Radius of the pulley that the string leaves; 0: a point.
    // Greatest deviation of the track from linearity, as a share of its length.
    double nonlinearity = 0;
    // Resistance of the track divided by that of the converter's input.
    double loading = 0;
    double noise_counts = 0.5;     // Standard deviation of white noise.
    double hum_counts = 0;         // Amplitude of hum at 50 Hz.
    double drift_counts_per_s = 0; // Drift of the reading as the supply warms up.
    double hysteresis_mm = 0;      // The string's end lags behind the table by half of this.
};

struct Geometry {
    double offset_mm = 100;
    double base_mm = 100;
    double track_mm = 600;    // String length that the whole potentiometer takes up.
    double first_part = 0.08; // Share of the track in use at height zero.
    int full_scale = 4095;
    bool is_spool_above = false; // True: base_mm is the distance of the spool above height zero.
    bool counts_down = false;    // True: the potentiometer's outer wires are swapped.
};

class Potentiometer {
public:
    Potentiometer(Geometry const& geometry, Faults const& faults, Dice& dice);

    // Lets the string slip, which shifts the wiper from now on, and raises the table's zero
    // relative to the pulley.
    void befall(double slip_mm, double move_mm);

    // Returns the converter's input in counts before rounding, with the table at rest.
    double counts(double height_mm) const;

    // Returns one reading; `direction` is +1 if the table came from below, -1 from above, 0
    // otherwise.
    int read(double height_mm, double direction, double seconds, Dice& dice) const;

private:
    double length(double height_mm) const;
    double bend(double part) const;

    Geometry geometry_;
    Faults faults_;
    double shortest_mm_ = 0; // Length of the string with the wiper at the beginning of the track.
    double hum_phase_ = 0;
    std::array<double, 4> waves_ {};
    double wave_scale_ = 0;
};

} // namespace tractus::physics
