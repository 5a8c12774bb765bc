#include "engine/variation/growth_plan.h"

#include "engine/base/check.h"

#include <cmath>
#include <complex>
#include <utility>

namespace tractus {

namespace {

using Steps = GrowthParameters::Steps;

// Numbers the segments that bear something, in the order in which it is found.
class Bearers {
public:
    explicit Bearers(GrowthPlan& plan)
        : plan_(plan)
    {
    }

    GrowthPlan::Seat seat(SegmentId segment, AxisId axis)
    {
        if (segment == kNone)
            return {};
        auto& bearer = plan_.segments[segment].bearer;
        if (bearer == kNone)
            bearer = plan_.bearer_count++;
        auto const& owner = plan_.base.axes[axis];
        return { bearer, owner.first_node + (segment - owner.first_segment) + 1 };
    }

    GrowthPlan::Seat seat(SegmentId segment)
    {
        return segment == kNone ? GrowthPlan::Seat {} : seat(segment, axis_of(plan_.base, segment));
    }

private:
    GrowthPlan& plan_;
};

// How the base plant's surroundings of a segment have turned.
Quat rotation_at(PredefinedShape const& shape, SegmentId segment)
{
    return segment == kNone ? Quat::Identity() : shape.rotation[segment];
}

// From where something stands to `position_mm`, in the predefined plant. What stands on the ground
// is measured from the origin.
Vec3 offset_mm(GrowthPlan const& plan, PredefinedShape const& shape, SegmentId segment,
               GrowthPlan::Seat const& seat, Vec3 const& position_mm)
{
    if (segment == kNone)
        return position_mm;
    return rotation_at(shape, segment) * (position_mm - plan.base.node_position_mm[seat.node]);
}

void seat_everything(GrowthPlan& plan, PredefinedShape const& shape)
{
    Bearers bearers(plan);
    auto const& base = plan.base;
    for (auto const& axis : base.axes) {
        auto const seat = bearers.seat(axis.parent_segment, axis.parent_axis);
        plan.axes.push_back({ seat,
                              offset_mm(plan, shape, axis.parent_segment, seat,
                                        base.node_position_mm[axis.first_node]) });
    }
    for (auto const& organ : base.organs) {
        auto const seat = bearers.seat(organ.segment);
        plan.organs.push_back({ seat,
                                offset_mm(plan, shape, organ.segment, seat, organ.position_mm),
                                rotation_at(shape, organ.segment) * organ.orientation });
    }
    plan.vertex_offset_mm = base.polygon_vertices_mm;
    for (auto const& polygon : base.polygons) {
        auto const seat = bearers.seat(polygon.segment);
        plan.polygons.push_back(seat);
        for (std::uint32_t i = 0; i < polygon.vertex_count; ++i) {
            auto& vertex = plan.vertex_offset_mm[polygon.first_vertex + i];
            vertex = offset_mm(plan, shape, polygon.segment, seat, vertex);
        }
    }
}

// The table of steps. Neighbours are often equally long and share one.
class StepTable {
public:
    StepTable(GrowthParameters const& parameters, std::vector<GrowthStep>& steps)
        : parameters_(parameters)
        , steps_(steps)
    {
        steps_.push_back({}); // Number 0 does nothing.
        steps_.push_back(unit_step(parameters));
    }

    std::uint32_t number(double length)
    {
        if (std::abs(length - last_length_) > 1e-13 * length) {
            steps_.push_back(exact_step(parameters_, length));
            last_length_ = length;
        }
        return static_cast<std::uint32_t>(steps_.size() - 1);
    }

    static constexpr std::uint32_t kRest = 0;
    static constexpr std::uint32_t kUnit = 1;

private:
    GrowthParameters const& parameters_;
    std::vector<GrowthStep>& steps_;
    double last_length_ = -1;
};

// The tip's own circling over a step of `length` that begins `start` steps from the base: the exact
// integral, scaled so that a step of length 1 gives what the law says.
Vec2 circumnutation(GrowthParameters const& p, double start, double length)
{
    std::complex<double> const i(0, 1);
    double const omega = 2 * kPi / p.circumnutation_period_steps;
    auto const swing = std::exp(i * omega * start);
    auto const share = (std::exp(i * omega * length) - std::pow(1 - p.gain, length))
        / (std::exp(i * omega) - (1 - p.gain));
    auto const push = p.strength * p.circumnutation_rad * swing * share;
    return { push.real(), push.imag() };
}

void find_steps_per_segment(GrowthPlan& plan, Axis const& axis)
{
    for (std::uint32_t i = 0; i < axis.segment_count; ++i)
        plan.segments[axis.first_segment + i].step = i == 0 ? StepTable::kRest : StepTable::kUnit;
    if (!plan.circumnutation_rad.empty())
        for (std::uint32_t i = 1; i < axis.segment_count; ++i)
            plan.circumnutation_rad[axis.first_segment + i]
                = circumnutation(plan.parameters, i - 1.0, 1);
}

// From the middle of a segment to the middle of the next, beginning at the base.
void find_steps_per_length(GrowthPlan& plan, Axis const& axis, double length_mm, StepTable& table)
{
    double const unit_mm = length_mm / plan.parameters.steps_per_axis;
    double before_mm = 0;
    double start = 0;
    for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
        auto& segment = plan.segments[axis.first_segment + i];
        double const length = unit_mm > 0 ? (before_mm + segment.length_mm) / 2 / unit_mm : 0;
        segment.step = table.number(length);
        if (!plan.circumnutation_rad.empty())
            plan.circumnutation_rad[axis.first_segment + i]
                = circumnutation(plan.parameters, start, length);
        before_mm = segment.length_mm;
        start += length;
    }
}

void find_steps(GrowthPlan& plan)
{
    auto const& parameters = plan.parameters;
    if (parameters.circumnutation_rad * parameters.strength != 0)
        plan.circumnutation_rad.assign(plan.segments.size(), Vec2::Zero());
    StepTable table(parameters, plan.steps);
    for (AxisId id = 0; id < plan.base.axes.size(); ++id) {
        auto const& axis = plan.base.axes[id];
        if (parameters.steps == Steps::PerSegment)
            find_steps_per_segment(plan, axis);
        else
            find_steps_per_length(plan, axis, plan.axis_length_mm[id], table);
    }
}

} // namespace

Result<GrowthPlan> plan_growth(Plant base, PredefinedShape const& shape,
                               GrowthParameters const& parameters, Vec3 const& influence)
{
    CHECK(shape.frame.size() == base.segment_count());
    CHECK(shape.rotation.size() == base.segment_count());
    TRY(check_growth_parameters(parameters));
    if (!influence.allFinite())
        return fail(Fault::User,
                    "the sum of the motion indicators is not a number: draw them again");

    GrowthPlan plan;
    plan.base = std::move(base);
    plan.parameters = parameters;
    plan.influence = influence;
    plan.levels = find_axis_levels(plan.base);
    plan.segments.resize(plan.base.segment_count());
    for (auto const& axis : plan.base.axes) {
        auto const nodes = plan.base.positions(axis);
        double length_mm = 0;
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto& segment = plan.segments[axis.first_segment + i];
            segment.direction = shape.frame[axis.first_segment + i].tangent;
            segment.normal = shape.frame[axis.first_segment + i].normal;
            segment.length_mm = (nodes[i + 1] - nodes[i]).norm();
            length_mm += segment.length_mm;
        }
        plan.axis_length_mm.push_back(length_mm);
    }
    seat_everything(plan, shape);
    find_steps(plan);
    return plan;
}

} // namespace tractus
