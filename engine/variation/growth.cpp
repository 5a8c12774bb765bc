#include "engine/variation/growth.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/variation/growth_tip.h"
#include "engine/variation/place_nodes.h"

#include <algorithm>
#include <array>
#include <span>

namespace tractus {

namespace {

constexpr std::size_t kBatch = GrowthNoise::kBatch;

// Grows the axes that it is given; what bears them must be grown.
class AxisGrower {
public:
    AxisGrower(GrowthPlan const& plan, GrowthNoise const& noise, Plant& plant,
               std::span<Quat> bearer_frame, double age)
        : plan_(plan)
        , noise_(noise)
        , plant_(plant)
        , bearer_frame_(bearer_frame)
        , age_(age)
        , is_stepped_(plan.parameters.delay_steps > 0 || plan.parameters.growth_zone_steps > 0)
    {
    }

    void grow(AxisId id) const
    {
        auto const& axis = plan_.base.axes[id];
        auto const& from = plan_.axes[id];
        Quat turn = Quat::Identity();
        Vec3 position_mm = from.offset_mm;
        if (from.seat.bearer != kNone) {
            auto const& grown = bearer_frame_[from.seat.bearer];
            turn = grown * plan_.bearer_frame[from.seat.bearer].conjugate();
            position_mm = plant_.node_position_mm[from.seat.node];
            if (!from.offset_mm.isZero(0))
                position_mm += grown * from.offset_mm;
        }
        plant_.node_position_mm[axis.first_node] = position_mm;

        AxisInfluence const influence(plan_, turn);
        auto const progress = progress_of(id);
        if (is_stepped_)
            place_all(SteppedTip(plan_, noise_, id, influence, progress), axis, turn, progress);
        else
            place_all(Tip(plan_, noise_, id, influence), axis, turn, progress);
    }

private:
    AxisProgress progress_of(AxisId id) const
    {
        double const length_mm = plan_.axis_length_mm[id];
        if (age_ >= 1)
            return { length_mm, 1 };
        auto const& age = plan_.axes[id].age;
        return { std::min(age.along_at_mm(age_), length_mm),
                 ripeness(age_, age.birth_at(length_mm)) };
    }

    template<typename AnyTip>
    void place_all(AnyTip tip, Axis const& axis, Quat const& turn,
                   AxisProgress const& progress) const
    {
        Vec3 position_mm = plant_.node_position_mm[axis.first_node];
        double left_mm = progress.along_mm; // For the segments to come.
        std::array<Vec2, kBatch> deviations;
        for (std::uint32_t first = 0; first < axis.segment_count; first += kBatch) {
            auto const count = std::min<std::uint32_t>(kBatch, axis.segment_count - first);
            tip.advance(std::span(deviations).first(count));
            auto const batch = std::span<Vec2 const>(deviations).first(count);
            if (age_ >= 1)
                place(axis, first, batch, turn, position_mm, [](double length) { return length; });
            else
                place(axis, first, batch, turn, position_mm, [&](double length) {
                    double const grown = std::clamp(left_mm, 0.0, length);
                    left_mm -= length;
                    return grown;
                });
        }
    }

    // Puts the nodes in place, and leaves the frames for what stands on the segments.
    template<typename GrownLength>
    void place(Axis const& axis, std::size_t first, std::span<Vec2 const> deviations,
               Quat const& turn, Vec3& position_mm, GrownLength const& grown_length) const
    {
        auto const* const segments = &plan_.segments[axis.first_segment + first];
        auto* const tips = &plant_.node_position_mm[axis.first_node + first + 1];
        Eigen::Matrix3d const rotation = turn.toRotationMatrix();
        for (std::size_t i = 0; i < deviations.size(); ++i) {
            auto const& segment = segments[i];
            auto const& d = deviations[i];
            auto const half = half_angle(d.squaredNorm());
            Vec3 const direction
                = rotation * (segment.frame.toRotationMatrix() * deviated(d, half));
            position_mm += grown_length(segment.length_mm) * direction;
            tips[i] = position_mm;
            if (segment.bearer != kNone)
                bearer_frame_[segment.bearer]
                    = renormalised(turn * segment.frame * turn_by(d, half));
        }
    }

    GrowthPlan const& plan_;
    GrowthNoise const& noise_;
    Plant& plant_;
    std::span<Quat> bearer_frame_;
    double age_;
    bool is_stepped_;
};

void carry_organs(GrowthPlan const& plan, std::span<Quat const> frames, Plant& plant)
{
    constexpr std::size_t kGrain = 2048;
    parallel_for(plan.organs.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const& from = plan.organs[i];
            if (from.seat.bearer == kNone)
                continue;
            auto const& frame = frames[from.seat.bearer];
            auto& organ = plant.organs[i];
            organ.position_mm = plant.node_position_mm[from.seat.node];
            if (!from.offset_mm.isZero(0))
                organ.position_mm += frame * from.offset_mm;
            organ.orientation = renormalised(frame * from.orientation);
        }
    });
}

void carry_sections(GrowthPlan const& plan, std::span<Quat const> frames, Plant& plant)
{
    if (plan.section_normal.empty())
        return;
    for (auto const& axis : plan.base.axes)
        for (std::uint32_t i = 0; i <= axis.segment_count; ++i) {
            auto const& segment
                = plan.segments[axis.first_segment + std::min(i, axis.segment_count - 1)];
            auto const node = axis.first_node + i;
            plant.node_section[node].normal
                = frames[segment.bearer].cast<float>() * plan.section_normal[node];
        }
}

void carry_polygons(GrowthPlan const& plan, std::span<Quat const> frames, double age, Plant& plant)
{
    for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
        auto const& [seat, birth] = plan.polygons[i];
        if (seat.bearer == kNone)
            continue;
        auto const& polygon = plan.base.polygons[i];
        double const size = age < 1 ? unfolded(age, birth) : 1;
        for (std::uint32_t n = 0; n < polygon.vertex_count; ++n) {
            auto const vertex = polygon.first_vertex + n;
            plant.polygon_vertices_mm[vertex] = plant.node_position_mm[seat.node]
                + size * (frames[seat.bearer] * plan.vertex_offset_mm[vertex]);
        }
    }
}

} // namespace

Grower::Grower(GrowthPlan const& plan)
    : plan_(plan)
    , plant_(plan.base)
    , bearer_frame_(plan.bearer_frame.size(), Quat::Identity())
    , sagger_(plan)
{
}

Plant const& Grower::grow(PlantKey const& key, double age)
{
    CHECK(age >= 0 && age <= 1);
    GrowthNoise const noise(key);
    if (age < 1 || is_aged_)
        age_plant(age);
    AxisGrower const grower(plan_, noise, plant_, bearer_frame_, age);
    for_each_level(plan_.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes)
            grower.grow(id);
    });
    if (plan_.parameters.sag > 0)
        sagger_.sag(plant_, bearer_frame_);
    carry_organs(plan_, bearer_frame_, plant_);
    if (age < 1)
        young_leaves_->place(plant_, age);
    carry_sections(plan_, bearer_frame_, plant_);
    carry_polygons(plan_, bearer_frame_, age, plant_);
    return plant_;
}

// Radii and sizes as they are at an age.
void Grower::age_plant(double age)
{
    is_aged_ = age < 1;
    auto const& base = plan_.base;
    if (!young_leaves_)
        young_leaves_.emplace(plan_);
    if (!is_aged_)
        plant_.node_radius_mm = base.node_radius_mm;
    for (std::size_t i = 0; i < base.organs.size(); ++i)
        plant_.organs[i].scale = base.organs[i].scale
            * static_cast<float>(is_aged_ ? unfolded(age, young_leaves_->sprout(i)) : 1);
    if (!is_aged_)
        return;
    for_each_level(plan_.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes) {
            auto const& axis = base.axes[id];
            auto const& axis_age = plan_.axes[id].age;
            double along_mm = 0;
            for (std::uint32_t i = 0; i <= axis.segment_count; ++i) {
                auto const node = axis.first_node + i;
                plant_.node_radius_mm[node] = base.node_radius_mm[node]
                    * static_cast<float>(ripeness(age, axis_age.birth_at(along_mm)));
                if (i < axis.segment_count)
                    along_mm += plan_.segments[axis.first_segment + i].length_mm;
            }
        }
    });
}

Result<Plant> grow(GrowthJob const& job)
{
    auto const rest = find_rest_shape(job.plant);
    auto const shape = TRY(resolve_associations(job.plant, rest, job.associations));
    std::vector<Vec3> nodes_mm;
    place_nodes(job.plant, rest, shape, nodes_mm);
    auto influence = TRY(
        influence_of(job.plant, nodes_mm, job.indicators, { job.shown_height_mm, job.scale }));
    auto const plan
        = TRY(plan_growth(job.plant, rest, shape, job.parameters, std::move(influence)));
    return Grower(plan).grow(job.key, job.age);
}

} // namespace tractus
