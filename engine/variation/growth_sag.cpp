#include "engine/variation/growth_sag.h"

#include "engine/stroke/frame_rotation.h"

#include <algorithm>
#include <cmath>

namespace tractus::variation {

namespace {

constexpr double kDensity = 1000e-9;    // Density of green wood, kg / mm³.
constexpr double kYoungsModulus = 6000; // Young's modulus of green wood, N / mm².
constexpr double kGravity = 9.81;       // Gravitational acceleration, N / kg.
constexpr int kRounds = 4;

// Returns the bending angle of a joint. `softness`: the angle in radians by which the load would
// bend the joint if held out horizontally. `sine` and `cosine`: of the angle a (0 to pi) between
// straight down and the direction from the joint to the load. The result is the root of angle =
// softness sin(a - angle), so it never exceeds a.
double sag_angle(double softness, double sine, double cosine)
{
    if (softness < 1e-3) // For such small angles one step of Newton's method is accurate to 1e-9.
        return softness * sine / (1 + softness * cosine);
    double const from_down = std::atan2(sine, cosine);
    double low = 0;
    double high = from_down;
    double angle = std::min(softness * sine / (1 + softness), from_down);
    for (int i = 0; i < 40; ++i) {
        double const error = angle - softness * std::sin(from_down - angle);
        (error > 0 ? high : low) = angle;
        double const slope = 1 + softness * std::cos(from_down - angle);
        double const newton = slope > 0 ? angle - error / slope : low;
        double const next = newton > low && newton < high ? newton : (low + high) / 2;
        if (std::abs(next - angle) < 1e-10)
            break;
        angle = next;
    }
    return angle;
}

} // namespace

// Computes the mass and moment of each segment together with its descendants, for the plant's
// present node positions.
void SagSimulator::find_loads(Plant const& plant)
{
    load_.assign(plant.segment_count(), {});
    // A plant lists parents before laterals, so the reverse order goes from the tips to the ground.
    for (std::size_t id = plant.axes.size(); id-- > 0;) {
        auto const& axis = plant.axes[id];
        Load sum;
        for (std::uint32_t i = axis.segment_count; i-- > 0;) {
            auto const node = axis.first_node + i;
            Vec3 const& base = plant.node_position_mm[node];
            Vec3 const& tip = plant.node_position_mm[node + 1];
            double const r0 = plant.node_radius_mm[node];
            double const r1 = plant.node_radius_mm[node + 1];
            double const mass
                = kDensity * kPi / 3 * (r0 * r0 + r0 * r1 + r1 * r1) * (tip - base).norm();
            // load_ already contains the loads of the laterals attached to this segment.
            auto& load = load_[axis.first_segment + i];
            sum.mass_kg += load.mass_kg + mass;
            sum.moment += load.moment + mass / 2 * (base + tip);
            load = sum;
        }
        if (axis.parent_segment != kNone) {
            load_[axis.parent_segment].mass_kg += sum.mass_kg;
            load_[axis.parent_segment].moment += sum.moment;
        }
    }
}

void SagSimulator::bend_axis(AxisId id, Plant& plant)
{
    auto const& axis = plant.axes[id];
    auto& position = plant.node_position_mm;
    Quat turn = Quat::Identity();
    // Position, in the previous round, of the base of the current segment.
    Vec3 before = position[axis.first_node];
    if (axis.parent_segment != kNone) {
        auto const& parent = plant.axes[axis.parent_axis];
        auto const node = parent.first_node + (axis.parent_segment - parent.first_segment) + 1;
        turn = turn_[axis.parent_segment];
        position[axis.first_node]
            = position[node] + turn * (grown_mm_[axis.first_node] - grown_mm_[node]);
    }
    double below_mm = 0; // Length of the preceding segment of the axis.
    for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
        auto const node = axis.first_node + i;
        auto const segment = axis.first_segment + i;
        Vec3 const step = grown_mm_[node + 1] - grown_mm_[node];
        double const length_mm = step.norm();
        auto const& load = load_[segment];
        // `hung` is the load's centre of mass relative to the segment's base, in the previous
        // round. `lever` is the same vector without the segment's sagging in that round, rotated
        // with the parent in this one.
        if (load.mass_kg > 0) {
            Vec3 const hung = load.moment / load.mass_kg - before;
            Vec3 const lever = turn * (turn_[segment].conjugate() * hung);
            double const radius = plant.node_radius_mm[node];
            double const stiffness = kYoungsModulus * kPi / 4 * std::pow(radius, 4);
            double const moment
                = kGravity * load.mass_kg * lever.norm() * (below_mm + length_mm) / 2;
            double const softness
                = std::min(plan_.parameters.sag * moment / std::max(stiffness, 1e-9), 1e6);
            double const aside = lever.head<2>().norm();
            if (aside > 1e-9 * lever.norm()) {
                double const length = lever.norm();
                double const angle = sag_angle(softness, aside / length, -lever.z() / length);
                Vec3 const level = Vec3(lever.y(), -lever.x(), 0) / aside;
                turn = renormalised(Quat(Eigen::AngleAxisd(-angle, level)) * turn);
            }
        }
        turn_[segment] = turn;
        before = position[node + 1];
        position[node + 1] = position[node] + turn * step;
        below_mm = length_mm;
    }
}

void SagSimulator::bend(Plant& plant)
{
    for_each_level(plan_.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes)
            bend_axis(id, plant);
    });
}

void SagSimulator::sag(Plant& plant, std::span<Quat> parent_frame, std::stop_token const& stop)
{
    grown_mm_ = plant.node_position_mm;
    turn_.assign(plant.segment_count(), Quat::Identity());
    for (int round = 0; round < kRounds && !stop.stop_requested(); ++round) {
        find_loads(plant);
        if (!stop.stop_requested())
            bend(plant);
    }
    if (stop.stop_requested())
        return;
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
        if (auto const parent = plan_.segments[segment].parent; parent != kNone)
            parent_frame[parent] = renormalised(turn_[segment] * parent_frame[parent]);
}

} // namespace tractus::variation
