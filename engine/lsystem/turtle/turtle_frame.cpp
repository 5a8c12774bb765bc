#include "engine/lsystem/turtle/turtle_frame.h"

#include "engine/lsystem/view/view.h"

#include <algorithm>

namespace tractus::lsystem {

void TurtleFrame::straighten()
{
    left = (left - left.dot(heading) * heading).normalized();
    down = left.cross(heading);
}

bool TurtleFrame::head_along(Vec3 const& new_heading)
{
    double const length = new_heading.norm();
    if (!(length > 1e-9) || !std::isfinite(length))
        return false;
    Quat const turn = rotation_between(heading, new_heading);
    heading = new_heading.normalized();
    left = (turn * left).normalized();
    straighten();
    return true;
}

void TurtleFrame::set_up(Vec3 const& up)
{
    Vec3 const across = up.cross(heading);
    if (!(across.norm() > 1e-9) || !std::isfinite(across.norm()))
        return;
    left = across.normalized();
    straighten();
}

void TurtleFrame::bend_by(Vec3 const& torque, TurtleFrame const& before)
{
    double const length = torque.norm();
    if (!(length >= 1e-6))
        return;
    Eigen::AngleAxisd const turn(std::min(length, 1.0), torque / length);
    heading = (turn * heading).normalized();
    transport_from(before);
}

void TurtleFrame::bend_towards(Vec3 const& direction, double elasticity)
{
    for (auto* const side : { &down, &left }) {
        double const sine = std::clamp(elasticity * direction.dot(*side), -1.0, 1.0);
        rotate(heading, *side, sine, std::sqrt(1 - sine * sine));
    }
}

void TurtleFrame::transport_from(TurtleFrame const& before)
{
    if (heading.cross(before.heading).norm() > 1e-6)
        left = rotation_between(before.heading, heading) * before.left;
    straighten();
}

// Rolls the frame so that its upper side turns towards the sum of the torques' directions. Sets
// `before` to the new frame.
static void twist_by_torques(TurtleFrame& frame, TurtleFrame& before,
                             std::vector<Tropism> const& tropisms, Elasticities const& elasticities)
{
    Vec3 pull = Vec3::Zero();
    for (std::size_t i = 0; i < std::min(tropisms.size(), kMaxTropisms); ++i)
        if (tropisms[i].is_torque)
            pull += elasticities[i] * from_model(tropisms[i].direction);
    Vec3 const across = pull - pull.dot(frame.heading) * frame.heading;
    if (!(across.norm() > 1e-4 * pull.norm()))
        return; // The heading already points in the direction of the torques.
    Vec3 const torque = -frame.down.cross(across);
    double const length = torque.norm();
    if (length >= 1e-7) {
        Eigen::AngleAxisd const turn(std::min(length, 1.0), torque / length);
        frame.left = turn * frame.left;
        frame.left = (frame.left - frame.left.dot(frame.heading) * frame.heading).normalized();
        frame.down = frame.left.cross(frame.heading);
    }
    before = frame;
}

// Returns the contribution of one tropism to the vector towards which the heading turns.
static Vec3 pull_of(Tropism const& tropism, double elasticity, TurtleFrame const& frame)
{
    Vec3 const direction = from_model(tropism.direction);
    double const angle_rad = radians(tropism.angle_deg);
    Vec3 const along = elasticity * std::cos(angle_rad) * direction;
    if (tropism.angle_deg == 0)
        return along;
    Vec3 across = frame.heading.cross(direction);
    double length = across.norm();
    if (length < 1e-7) {
        across = frame.left;
        length = 1;
    }
    return along + elasticity * std::sin(angle_rad) / length * direction.cross(across);
}

void bend_by_tropisms(TurtleFrame& frame, TurtleFrame& before, std::vector<Tropism> const& tropisms,
                      Elasticities const& elasticities)
{
    Vec3 pull = Vec3::Zero();
    bool has_torque = false;
    for (std::size_t i = 0; i < std::min(tropisms.size(), kMaxTropisms); ++i) {
        if (elasticities[i] == 0)
            continue;
        if (tropisms[i].is_torque)
            has_torque = true;
        else
            pull += pull_of(tropisms[i], elasticities[i], frame);
    }
    frame.bend_by(frame.heading.cross(pull), before);
    if (has_torque)
        twist_by_torques(frame, before, tropisms, elasticities);
}

} // namespace tractus::lsystem
