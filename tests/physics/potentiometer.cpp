#include "tests/physics/potentiometer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tractus::physics {

namespace {

constexpr double kPi = std::numbers::pi;

} // namespace

double uniform(Dice& dice, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(dice);
}

double normal(Dice& dice, double deviation)
{
    return deviation > 0 ? std::normal_distribution<double>(0, deviation)(dice) : 0;
}

Potentiometer::Potentiometer(Geometry const& geometry, Faults const& faults, Dice& dice)
    : geometry_(geometry)
    , faults_(faults)
{
    shortest_mm_ = length(0);
    hum_phase_ = uniform(dice, 0, 2 * kPi);
    for (std::size_t k = 0; k < waves_.size(); ++k)
        waves_[k] = normal(dice, 1) / static_cast<double>(k + 1);
    // Scales the waves so that the track's greatest deviation is that of the data sheet.
    wave_scale_ = 1;
    double greatest = 1e-12;
    for (int i = 0; i <= 200; ++i)
        greatest = std::max(greatest, std::abs(bend(i / 200.0)));
    wave_scale_ = 1 / greatest;
}

void Potentiometer::befall(double slip_mm, double move_mm)
{
    shortest_mm_ -= slip_mm;
    geometry_.base_mm += move_mm;
}

// Returns the length of the string from the table to the pulley, plus the length that is wound
// around the pulley. The wound length has an arbitrary zero.
double Potentiometer::length(double height_mm) const
{
    double const rise_mm
        = geometry_.is_spool_above ? geometry_.base_mm - height_mm : geometry_.base_mm + height_mm;
    double const straight_mm = std::hypot(rise_mm, geometry_.offset_mm);
    double const radius_mm = faults_.pulley_radius_mm;
    if (radius_mm == 0)
        return straight_mm;
    double const tangent_mm = std::sqrt(straight_mm * straight_mm - radius_mm * radius_mm);
    double const angle
        = std::atan2(rise_mm, geometry_.offset_mm) + std::acos(radius_mm / straight_mm);
    return tangent_mm - radius_mm * angle;
}

double Potentiometer::bend(double part) const
{
    double sum = 0;
    for (std::size_t k = 0; k < waves_.size(); ++k)
        sum += waves_[k] * std::sin(static_cast<double>(k + 1) * kPi * part);
    return wave_scale_ * sum;
}

double Potentiometer::counts(double height_mm) const
{
    double const wound
        = geometry_.first_part + (length(height_mm) - shortest_mm_) / geometry_.track_mm;
    double const along = wound + faults_.nonlinearity * bend(wound);
    double const part = geometry_.counts_down ? 1 - along : along;
    // The track is a voltage divider whose lower half the converter's input bridges.
    double const loaded = part / (1 + faults_.loading * part * (1 - part));
    return geometry_.full_scale * loaded;
}

int Potentiometer::read(double height_mm, double direction, double seconds, Dice& dice) const
{
    double const clean = counts(height_mm - direction * faults_.hysteresis_mm / 2);
    double const hum = faults_.hum_counts * std::sin(2 * kPi * 50 * seconds + hum_phase_);
    double const reading
        = clean + hum + faults_.drift_counts_per_s * seconds + normal(dice, faults_.noise_counts);
    return static_cast<int>(
        std::clamp(std::round(reading), 0.0, static_cast<double>(geometry_.full_scale)));
}

} // namespace tractus::physics
