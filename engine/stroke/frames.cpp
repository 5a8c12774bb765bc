#include "engine/stroke/frames.h"

#include "engine/base/check.h"

namespace tractus {

Vec3 normal_towards(Vec3 const& tangent, Vec3 const& side)
{
    Vec3 const across = side - side.dot(tangent) * tangent;
    double const size = across.norm();
    return size > 1e-9 * side.norm() ? Vec3(across / size) : any_normal(tangent);
}

Vec3 any_normal(Vec3 const& tangent)
{
    Vec3 const side = std::abs(tangent.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    return (side - side.dot(tangent) * tangent).normalized();
}

Quat least_rotation(Vec3 const& from, Vec3 const& to)
{
    // Builds the quaternion of the rotation by an angle a without trigonometric functions: w = 2
    // cos²(a/2) and |cross| = 2 sin(a/2) cos(a/2) have the common factor 2 cos(a/2).
    double const w = 1 + from.dot(to);
    if (w < 1e-14) {
        Vec3 const axis = any_normal(from);
        return Quat(0, axis.x(), axis.y(), axis.z());
    }
    Vec3 const axis = from.cross(to);
    return Quat(w, axis.x(), axis.y(), axis.z()).normalized();
}

static std::vector<Vec3> segment_directions(std::span<Vec3 const> points)
{
    std::vector<Vec3> directions(points.size() - 1, Vec3::Zero());
    Vec3 last = Vec3::UnitZ();
    // Iterates backwards, so that `last` ends as the direction of the first segment that has a
    // length.
    for (std::size_t i = directions.size(); i-- > 0;) {
        Vec3 const step = points[i + 1] - points[i];
        if (double const length = step.norm(); length > 0)
            last = directions[i] = step / length;
    }
    for (auto& direction : directions) {
        if (direction.isZero(0))
            direction = last;
        last = direction;
    }
    return directions;
}

std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points,
                                              Vec3 const& first_normal)
{
    CHECK(points.size() >= 2);
    auto const directions = segment_directions(points);
    std::vector<Frame> frames;
    frames.reserve(directions.size());
    frames.push_back({ directions[0], normal_towards(directions[0], first_normal) });
    for (std::size_t i = 1; i < directions.size(); ++i) {
        auto const turn = least_rotation(directions[i - 1], directions[i]);
        // Made orthogonal again, since rounding errors would accumulate along the line.
        frames.push_back(
            { directions[i], normal_towards(directions[i], turn * frames.back().normal) });
    }
    return frames;
}

std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points)
{
    return rotation_minimising_frames(points, Vec3::UnitX());
}

} // namespace tractus
