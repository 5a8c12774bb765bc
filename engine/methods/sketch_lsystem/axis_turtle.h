#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"

#include <cmath>

namespace tractus::sketch {

// A turtle with those commands of cpfg's turtle that a drawn axis and its laterals need.
class AxisTurtle {
public:
    explicit AxisTurtle(Vec3 const& position_mm)
        : position_mm_(position_mm)
    {
    }

    // The turn that points the turtle's heading along `way`.
    Turn turn_towards(Vec3 const& way) const
    {
        // For a bend below this angle, the plane of the turn would be numerical noise.
        constexpr double kStraight_deg = 1e-6;
        double const left = left_.dot(way);
        double const down = down_.dot(way);
        double const bend_deg = degrees(std::atan2(std::hypot(left, down), heading_.dot(way)));
        if (bend_deg < kStraight_deg)
            return {};
        return { degrees(std::atan2(down, left)), bend_deg };
    }

    void turn(Turn const& turn)
    {
        rotate(left_, down_, turn.plane_deg);
        rotate(heading_, left_, turn.bend_deg);
        rotate(left_, down_, -turn.plane_deg);
    }

    // Rotates a vector with the turtle: `from_start` is given for the turtle's start orientation,
    // the result is for its present one.
    Vec3 vector_from_start(Vec3 const& from_start) const
    {
        return from_start.z() * heading_ - from_start.x() * left_ + from_start.y() * down_;
    }

    // Rolls about the heading: `/` in turtle commands.
    void roll(double angle_deg) { rotate(left_, down_, angle_deg); }
    // Turns to the left: `+` in turtle commands.
    void yaw(double angle_deg) { rotate(heading_, left_, angle_deg); }

    Vec3 const& position_mm() const { return position_mm_; }

    Vec3 const& go(double length_mm)
    {
        position_mm_ += length_mm * heading_;
        return position_mm_;
    }

private:
    static void rotate(Vec3& from, Vec3& to, double angle_deg)
    {
        double const sine = std::sin(radians(angle_deg));
        double const cosine = std::cos(radians(angle_deg));
        Vec3 const old_from = from;
        from = cosine * old_from + sine * to;
        to = cosine * to - sine * old_from;
    }

    Vec3 position_mm_;
    Vec3 heading_ = Vec3::UnitZ();
    Vec3 left_ = -Vec3::UnitX();
    Vec3 down_ = Vec3::UnitY();
};

} // namespace tractus::sketch
