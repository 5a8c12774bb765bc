#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

struct Tropism;

// Takes a vector from cpfg's space (x right, y up, z to the viewer) to the plant's (z up).
inline Vec3 from_model(Vec3 const& v)
{
    return { v.x(), -v.z(), v.y() };
}

// Sine and cosine of the angles that came last: a model turns by few angles, again and again.
class AngleCache {
public:
    struct Entry {
        double angle_deg = 0;
        double sine = 0;
        double cosine = 1;
    };

    // Beyond a full turn only what is over counts.
    Entry const& at(double angle_deg)
    {
        auto const bits = std::bit_cast<std::uint64_t>(angle_deg);
        auto& entry = entries_[(bits ^ bits >> 32) * 0x9e3779b97f4a7c15u >> 59];
        if (entry.angle_deg != angle_deg) {
            double const angle_rad = radians(std::fmod(angle_deg, 360));
            entry = { angle_deg, std::sin(angle_rad), std::cos(angle_rad) };
        }
        return entry;
    }

private:
    std::array<Entry, 32> entries_ {};
};

// Where the turtle is and how it lies, in the plant's frame; the three directions are orthonormal.
struct TurtleFrame {
    Vec3 position_mm = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 left = -Vec3::UnitX();
    // The direction that cpfg calls up; it points away from the upper side, so that heading x down
    // = left.
    Vec3 down = Vec3::UnitY();

    // Turns one of the directions towards another in their plane.
    static void rotate(Vec3& a, Vec3& b, double sine, double cosine)
    {
        Vec3 const turned = cosine * a + sine * b;
        b = cosine * b - sine * a;
        a = turned;
    }

    // The left becomes horizontal, the upper side looks up. No change when the turtle heads
    // straight up or down.
    void roll_horizontal()
    {
        // The vertical's cross product with the heading; the left has no height, which spares half.
        double const length = std::sqrt(heading.x() * heading.x() + heading.y() * heading.y());
        if (length < 1e-9)
            return;
        left = { -heading.y() / length, heading.x() / length, 0 };
        down = { left.y() * heading.z(), -left.x() * heading.z(),
                 left.x() * heading.y() - left.y() * heading.x() };
    }

    // Heads along `new_heading` with the least twist. False, and no change, for a direction of no
    // length.
    bool head_along(Vec3 const& new_heading);
    // Turns the upper side away from `up`, cpfg's third direction, as far as the heading allows.
    void set_up(Vec3 const& up);

    // Turns about `torque` by its length, at most 1 radian. The sides are carried from `before`
    // with the least twist.
    void bend_by(Vec3 const& torque, TurtleFrame const& before);

    // cpfg's older tropism: pitches and turns towards `direction`, as far as its parts across the
    // heading say.
    void bend_towards(Vec3 const& direction, double elasticity);

    // The sides lie as if `before`'s were carried to this heading with the least twist. No change
    // where the headings are the same.
    void carry_from(TurtleFrame const& before);

private:
    // Makes left and down perpendicular to the heading again.
    void straighten();
};

// The tropisms of a view: cpfg's laws. An elasticity stands for each tropism.
constexpr std::size_t kMaxTropisms = 8;
using Elasticities = std::array<double, kMaxTropisms>;

// Bends the frame before a step: the heading turns towards V = sum e (cos g T + sin g T x (H x T) /
// |H x T|), about H x V and by its length in radians; torques then roll it.
//
// `before` is the frame behind the last segment, or where @Tf stood: cpfg carries the sides from
// there, so that rolls since then are lost where a tropism bends. A torque moves it.
void bend_by_tropisms(TurtleFrame& frame, TurtleFrame& before, std::vector<Tropism> const& tropisms,
                      Elasticities const& elasticities);

} // namespace tractus::lsystem
