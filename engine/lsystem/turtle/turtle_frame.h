#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

struct Tropism;

// Converts a vector from cpfg's space (x right, y up, z towards the viewer) to the plant's space (z
// up).
inline Vec3 from_model(Vec3 const& v)
{
    return { v.x(), -v.z(), v.y() };
}

// Caches sines and cosines of recently used angles, because a model uses few different angles.
class AngleCache {
public:
    struct Entry {
        double angle_deg = 0;
        double sine = 0;
        double cosine = 1;
    };

    // Returns the sine and cosine of an angle, which is reduced modulo 360 degrees.
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

// Position and orientation of the turtle in the plant's frame. The three vectors are orthonormal.
struct TurtleFrame {
    Vec3 position_mm = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 left = -Vec3::UnitX();
    // The vector that cpfg calls up. It points away from the turtle's upper side, so that the cross
    // product of heading and down is left.
    Vec3 down = Vec3::UnitY();

    // Rotates two orthogonal vectors in their common plane, the first towards the second.
    static void rotate(Vec3& a, Vec3& b, double sine, double cosine)
    {
        Vec3 const turned = cosine * a + sine * b;
        b = cosine * b - sine * a;
        a = turned;
    }

    // Rolls the turtle until the left vector is horizontal and the upper side faces up. Does
    // nothing if the heading is vertical.
    void roll_horizontal()
    {
        // Cross product of the vertical and the heading. Its z is 0, which saves half of the work.
        double const length = std::sqrt(heading.x() * heading.x() + heading.y() * heading.y());
        if (length < 1e-9)
            return;
        left = { -heading.y() / length, heading.x() / length, 0 };
        down = { left.y() * heading.z(), -left.x() * heading.z(),
                 left.x() * heading.y() - left.y() * heading.x() };
    }

    // Turns the heading to `new_heading` by the rotation of smallest angle. Returns false and
    // changes nothing if that vector has zero length.
    bool head_along(Vec3 const& new_heading);
    // Rolls the turtle until its upper side faces away from `up`, as far as the heading allows. In
    // cpfg `up` is the third vector of the frame.
    void set_up(Vec3 const& up);

    // Rotates the heading about the vector `torque`, by its length in radians, at most 1. Parallel
    // transport carries the sides from the frame `before`.
    void bend_by(Vec3 const& torque, TurtleFrame const& before);

    // Applies the older kind of tropism in cpfg: pitches and turns the heading towards `direction`,
    // in proportion to that vector's components across the heading.
    void bend_towards(Vec3 const& direction, double elasticity);

    // Carries the sides by parallel transport from the frame `before` to this frame's heading. Does
    // nothing if the two headings are equal.
    void transport_from(TurtleFrame const& before);

private:
    // Makes left and down perpendicular to the heading again.
    void straighten();
};

// Maximum number of tropisms in a view. Limits and laws of tropisms are those of cpfg.
constexpr std::size_t kMaxTropisms = 8;
using Elasticities = std::array<double, kMaxTropisms>;

// Bends the frame before a step. The heading H turns towards V, the sum of
// e (cos g T + sin g T x (H x T) / |H x T|) over the tropisms with elasticity e, direction T and
// angle g. It turns about H x V, by the length of H x V in radians. Then tropisms that are torques
// roll the frame.
//
// `before` is the frame after the last segment, or at the last @Tf. As in cpfg, parallel transport
// carries the sides from there, so rolls since then are lost where a tropism bends the heading. A
// torque sets `before` to the new frame.
void bend_by_tropisms(TurtleFrame& frame, TurtleFrame& before, std::vector<Tropism> const& tropisms,
                      Elasticities const& elasticities);

} // namespace tractus::lsystem
