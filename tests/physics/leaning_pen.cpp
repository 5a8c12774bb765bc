#include "tests/physics/leaning_pen.h"

#include <cmath>

namespace tractus::physics {

namespace {

// Returns the direction of a pen's shaft. The pen starts upright, is leaned towards +x, and then
// rotated about the vertical axis.
Vec3 shaft_of(Hold const& hold)
{
    double const aside = std::sin(hold.lean_rad);
    return { aside * std::cos(hold.azimuth_rad), aside * std::sin(hold.azimuth_rad),
             std::cos(hold.lean_rad) };
}

// Returns the tilt along one axis, with noise. It is the angle between two planes through the other
// horizontal axis: the vertical one, and the one that contains the shaft.
double tilt_deg(double along, double up, double noise_deg, Dice& dice)
{
    double const angle = std::atan2(along, up) * 180 / kPi;
    return std::round(angle + normal(dice, noise_deg));
}

} // namespace

PenRecording record_pen(NibPath const& way, Holding const& holding, double seconds,
                        Tablet const& tablet, Dice& dice)
{
    PenRecording recording;
    double const phase_s = uniform(dice, 0, 1 / tablet.pen_hz);
    for (double t = phase_s; t < seconds; t += 1 / tablet.pen_hz) {
        Vec2 const nib = way(t);
        Vec3 const shaft = shaft_of(holding(t));
        Vec3 const told = shaft_of(holding(t - tablet.tilt_late_s));
        double const up = tablet.sight == Sight::Below ? 1 : 1 / shaft.z();
        Vec2 const coil = nib + tablet.coil_mm * up * shaft.head<2>();
        double const x_deg = tilt_deg(told.x(), told.z(), tablet.tilt_noise_deg, dice);
        double const y_deg = tilt_deg(told.y(), told.z(), tablet.tilt_noise_deg, dice);
        recording.samples.push_back(
            { .time = Timestamp(std::chrono::nanoseconds(std::llround(t * 1e9))),
              .position_mm = coil
                  + Vec2(normal(dice, tablet.place_noise_mm), normal(dice, tablet.place_noise_mm)),
              .pressure = 1,
              .tilt_rad = Vec2(x_deg, tablet.is_y_inverted ? -y_deg : y_deg) * (kPi / 180),
              .in_range = true,
              .touching = true });
        recording.nibs_mm.push_back(nib);
    }
    return recording;
}

} // namespace tractus::physics
