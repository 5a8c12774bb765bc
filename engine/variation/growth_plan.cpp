#include "engine/variation/growth_plan.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

namespace tractus::variation {

namespace {

using Steps = GrowthParameters::Steps;

// Numbers the segments that have attachments, in the order in which the attachments are found.
class Parents {
public:
    Parents(GrowthPlan& plan, RestShape const& rest)
        : plan_(plan)
        , rest_(rest)
    {
    }

    GrowthPlan::Seat seat(SegmentId segment, AxisId axis)
    {
        if (segment == kNone)
            return {};
        auto& parent = plan_.segments[segment].parent;
        if (parent == kNone) {
            parent = static_cast<std::uint32_t>(plan_.parent_frame.size());
            plan_.parent_frame.push_back(plan_.segments[segment].frame);
        }
        auto const& owner = plan_.base.axes[axis];
        return { parent, owner.first_node + (segment - owner.first_segment) + 1 };
    }

    // Returns the rotation from the base plant's frame to that of the parent segment; the identity
    // for the ground.
    Quat to_frame(SegmentId segment) const
    {
        return segment == kNone ? Quat::Identity() : rest_.frame[segment].conjugate();
    }

    // Returns the offset from the seat's node to `position_mm`, in the parent segment's frame; for
    // the ground, `position_mm` itself.
    Vec3 offset_mm(SegmentId segment, GrowthPlan::Seat const& seat, Vec3 const& position_mm) const
    {
        if (segment == kNone)
            return position_mm;
        return to_frame(segment) * (position_mm - plan_.base.node_position_mm[seat.node]);
    }

    // Returns the plant's age at which a segment is complete; 0 for the ground.
    double birth_of_end(SegmentId segment, AxisId axis) const
    {
        return segment == kNone ? 0 : plan_.axes[axis].age.birth_at(rest_.end_mm[segment]);
    }

private:
    GrowthPlan& plan_;
    RestShape const& rest_;
};

void seat_axes(GrowthPlan& plan, RestShape const& rest, Parents& parents)
{
    auto const& base = plan.base;
    auto const ages = find_axis_ages(base, rest);
    plan.axes.reserve(base.axes.size());
    for (AxisId id = 0; id < base.axes.size(); ++id) {
        auto const& axis = base.axes[id];
        auto const seat = parents.seat(axis.parent_segment, axis.parent_axis);
        auto const offset_mm
            = parents.offset_mm(axis.parent_segment, seat, base.node_position_mm[axis.first_node]);
        plan.axes.push_back({ seat, offset_mm, ages[id] });
    }
}

// Finds the attachments of organs and polygons. Each appears when the segment that carries it is
// complete.
void seat_riders(GrowthPlan& plan, Parents& parents)
{
    auto const& base = plan.base;
    plan.organs.reserve(base.organs.size());
    for (auto const& organ : base.organs) {
        AxisId const axis = organ.segment == kNone ? kNone : axis_of(base, organ.segment);
        auto const seat = parents.seat(organ.segment, axis);
        plan.organs.push_back({ seat, parents.offset_mm(organ.segment, seat, organ.position_mm),
                                parents.to_frame(organ.segment) * organ.orientation,
                                parents.birth_of_end(organ.segment, axis) });
    }
    plan.vertex_offset_mm = base.polygon_vertices_mm;
    for (auto const& polygon : base.polygons) {
        AxisId const axis = polygon.segment == kNone ? kNone : axis_of(base, polygon.segment);
        auto const seat = parents.seat(polygon.segment, axis);
        plan.polygons.push_back({ seat, parents.birth_of_end(polygon.segment, axis) });
        for (std::uint32_t i = 0; i < polygon.vertex_count; ++i) {
            auto& vertex = plan.vertex_offset_mm[polygon.first_vertex + i];
            vertex = parents.offset_mm(polygon.segment, seat, vertex);
        }
    }
}

// Computes the normals of the cross-sections, in the frames of their segments.
void seat_sections(GrowthPlan& plan, RestShape const& rest, Parents& parents)
{
    auto const& base = plan.base;
    if (base.node_section.empty())
        return;
    plan.section_normal.resize(base.node_section.size());
    for (AxisId id = 0; id < base.axes.size(); ++id) {
        auto const& axis = base.axes[id];
        for (std::uint32_t i = 0; i <= axis.segment_count; ++i) {
            auto const segment = axis.first_segment + std::min(i, axis.segment_count - 1);
            auto const node = axis.first_node + i;
            (void)parents.seat(segment, id);
            plan.section_normal[node]
                = rest.frame[segment].conjugate().cast<float>() * base.node_section[node].normal;
        }
    }
}

// Fills GrowthPlan::steps. Successive steps of equal length share one entry.
class StepTable {
public:
    StepTable(GrowthParameters const& parameters, std::vector<GrowthStep>& steps)
        : parameters_(parameters)
        , steps_(steps)
    {
        steps_.push_back({}); // Entry kRest: a step without effect.
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

// Returns the deviation by circumnutation over a step of `length` that begins `start` steps from
// the base: the exact integral, scaled so that a step of length 1 matches the law.
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

// Finds the steps of an axis: the first from its base to the middle of its first segment, the
// others from the middle of a segment to the middle of the next.
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

Result<GrowthPlan> plan_growth(Plant base, RestShape const& rest, PredefinedShape const& shape,
                               GrowthParameters const& parameters, Influence influence,
                               std::stop_token const& stop)
{
    CHECK(shape.frame.size() == base.segment_count());
    CHECK(rest.frame.size() == base.segment_count());
    CHECK(influence.local.empty() || influence.local.size() == base.segment_count());
    TRY(check_growth_parameters(parameters));
    if (!influence.everywhere.allFinite())
        return fail(Fault::User,
                    "the sum of the motion indicators is not a number: draw them again");

    GrowthPlan plan;
    plan.base = std::move(base);
    plan.parameters = parameters;
    plan.influence = std::move(influence);
    plan.influence.everywhere += parameters.prevailing;
    plan.levels = rest.levels;
    plan.axis_length_mm = rest.axis_length_mm;
    plan.segments.resize(plan.base.segment_count());
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
        plan.segments[i].frame = shape.frame[i];
        plan.segments[i].length_mm = rest.length_mm[i];
    }
    Parents parents(plan, rest);
    std::function<void()> const parts[] {
        [&] { seat_axes(plan, rest, parents); },
        [&] { seat_riders(plan, parents); },
        [&] { seat_sections(plan, rest, parents); },
        [&] { find_steps(plan); },
    };
    for (auto const& part : parts) {
        if (stop.stop_requested())
            return GrowthPlan {};
        part();
    }
    return plan;
}

} // namespace tractus::variation
