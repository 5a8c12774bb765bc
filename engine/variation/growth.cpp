#include "engine/variation/growth.h"

#include "engine/base/parallel.h"
#include "engine/variation/growth_tip.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <span>

namespace tractus {

namespace {

constexpr std::size_t kBatch = GrowthNoise::kBatch;

// Grows the axes that it is given; what bears them must be grown.
class AxisGrower {
public:
    AxisGrower(GrowthPlan const& plan, GrowthNoise const& noise, Plant& plant,
               std::span<Quat> turns)
        : plan_(plan)
        , noise_(noise)
        , plant_(plant)
        , turns_(turns)
    {
    }

    void grow(AxisId id) const
    {
        auto const& axis = plan_.base.axes[id];
        auto const& from = plan_.axes[id];
        Quat turn = Quat::Identity();
        Vec3 position_mm = from.offset_mm;
        if (from.seat.bearer != kNone) {
            turn = turns_[from.seat.bearer];
            position_mm = plant_.node_position_mm[from.seat.node] + turn * from.offset_mm;
        }
        plant_.node_position_mm[axis.first_node] = position_mm;

        Vec3 const influence = turn.conjugate() * plan_.influence;
        if (plan_.parameters.delay_steps > 0)
            place_all(DelayedTip(plan_, noise_, id, influence), axis, turn, position_mm);
        else
            place_all(Tip(plan_, noise_, id, influence), axis, turn, position_mm);
    }

private:
    template<typename AnyTip>
    void place_all(AnyTip tip, Axis const& axis, Quat const& turn, Vec3 position_mm) const
    {
        std::array<Vec2, kBatch> deviations;
        for (std::uint32_t first = 0; first < axis.segment_count; first += kBatch) {
            auto const count = std::min<std::uint32_t>(kBatch, axis.segment_count - first);
            tip.advance(std::span(deviations).first(count));
            place(axis, first, std::span(deviations).first(count), turn, position_mm);
        }
    }

    // Puts the nodes in place, and leaves the turns for what stands on the segments.
    void place(Axis const& axis, std::size_t first, std::span<Vec2 const> deviations,
               Quat const& turn, Vec3& position_mm) const
    {
        Eigen::Matrix3d const rotation = turn.toRotationMatrix();
        auto const* const segments = &plan_.segments[axis.first_segment + first];
        auto* const tips = &plant_.node_position_mm[axis.first_node + first + 1];
        for (std::size_t i = 0; i < deviations.size(); ++i) {
            auto const& segment = segments[i];
            Vec3 const binormal = segment.direction.cross(segment.normal);
            auto const half = half_angle(deviations[i].squaredNorm());
            position_mm += segment.length_mm
                * (rotation * deviated(segment, binormal, deviations[i], half));
            tips[i] = position_mm;
            if (segment.bearer != kNone)
                turns_[segment.bearer]
                    = (turn * turn_by(segment, binormal, deviations[i], half)).normalized();
        }
    }

    GrowthPlan const& plan_;
    GrowthNoise const& noise_;
    Plant& plant_;
    std::span<Quat> turns_;
};

void carry_organs(GrowthPlan const& plan, std::span<Quat const> turns, Plant& plant)
{
    constexpr std::size_t kGrain = 2048;
    parallel_for(plan.organs.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const& from = plan.organs[i];
            if (from.seat.bearer == kNone)
                continue;
            auto const& turn = turns[from.seat.bearer];
            auto& organ = plant.organs[i];
            organ.position_mm = plant.node_position_mm[from.seat.node] + turn * from.offset_mm;
            organ.orientation = turn * from.orientation;
        }
    });
}

void carry_polygons(GrowthPlan const& plan, std::span<Quat const> turns, Plant& plant)
{
    for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
        auto const& seat = plan.polygons[i];
        if (seat.bearer == kNone)
            continue;
        auto const& polygon = plan.base.polygons[i];
        for (std::uint32_t n = 0; n < polygon.vertex_count; ++n) {
            auto const vertex = polygon.first_vertex + n;
            plant.polygon_vertices_mm[vertex] = plant.node_position_mm[seat.node]
                + turns[seat.bearer] * plan.vertex_offset_mm[vertex];
        }
    }
}

} // namespace

Grower::Grower(GrowthPlan const& plan)
    : plan_(plan)
    , plant_(plan.base)
    , turns_(plan.bearer_count, Quat::Identity())
{
}

Plant const& Grower::grow(PlantKey const& key)
{
    GrowthNoise const noise(key);
    AxisGrower const grower(plan_, noise, plant_, turns_);
    for_each_level(plan_.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes)
            grower.grow(id);
    });
    carry_organs(plan_, turns_, plant_);
    carry_polygons(plan_, turns_, plant_);
    return plant_;
}

Result<Plant> grow(GrowthJob const& job)
{
    Vec3 influence = Vec3::Zero();
    if (!job.indicators.empty()) {
        if (!(job.shown_height_mm > 0))
            return fail(Fault::User,
                        fmt::format("the motion indicators are measured against a plant "
                                    "shown {} mm high: show it above 0 mm",
                                    job.shown_height_mm));
        influence = summed_influence(job.indicators, job.shown_height_mm);
    }
    auto const shape = TRY(resolve_associations(job.plant, job.associations));
    auto const plan = TRY(plan_growth(job.plant, shape, job.parameters, influence));
    return Grower(plan).grow(job.key);
}

} // namespace tractus
