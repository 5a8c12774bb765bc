#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <array>
#include <optional>

namespace tractus::view {

// The box that views frame while something grows that fills no box yet, such as the first plant of
// an empty sheet. The box has room for more than there is, and becomes larger in few, distinct
// steps, so that views do not zoom with each movement of the pen. It never becomes smaller.
//
// The box reaches at least kFirstHeight_mm upwards and kFirstReach_mm in each horizontal direction
// from the first point of what grows; a step multiplies a reach by kStep. The box does not reach
// below the lowest point. Any frame and unit; the constants are for millimetres on the desk.
class SteadyFrame {
public:
    static constexpr double kFirstReach_mm = 20;
    static constexpr double kFirstHeight_mm = 60;
    static constexpr double kStep = 1.6;

    // `unit`: how many of the frame's millimetres one millimetre on the desk is.
    explicit SteadyFrame(double unit = 1)
        : unit_(unit)
    {
    }

    // Makes room for a point.
    void add(Vec3 const& point_mm);

    // Empty before the first point.
    Bounds box_mm() const;

private:
    double unit_;
    std::optional<Vec3> first_mm_ {};
    double lowest_mm_ = 0;
    std::array<double, 5> reach_mm_ {}; // Towards -x, +x, -y, +y and +z, from the first point.
};

} // namespace tractus::view
