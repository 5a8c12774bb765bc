#include "engine/variation/growth.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/stroke/frame_rotation.h"
#include "engine/variation/growth_bundle.h"
#include "engine/variation/place_nodes.h"

#include <algorithm>
#include <span>

namespace tractus::variation {

namespace {

void carry_organs(GrowthPlan const& plan, std::span<Quat const> frames, Plant& plant)
{
    constexpr std::size_t kGrain = 2048;
    parallel_for(plan.organs.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const& from = plan.organs[i];
            if (from.seat.parent == kNone)
                continue;
            auto const& frame = frames[from.seat.parent];
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
                = frames[segment.parent].cast<float>() * plan.section_normal[node];
        }
}

void carry_polygons(GrowthPlan const& plan, std::span<Quat const> frames, double age, Plant& plant)
{
    for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
        auto const& [seat, birth] = plan.polygons[i];
        if (seat.parent == kNone)
            continue;
        auto const& polygon = plan.base.polygons[i];
        double const size = age < 1 ? unfolded(age, birth) : 1;
        for (std::uint32_t n = 0; n < polygon.vertex_count; ++n) {
            auto const vertex = polygon.first_vertex + n;
            plant.polygon_vertices_mm[vertex] = plant.node_position_mm[seat.node]
                + size * (frames[seat.parent] * plan.vertex_offset_mm[vertex]);
        }
    }
}

} // namespace

Grower::Grower(GrowthPlan const& plan)
    : plan_(plan)
    , plant_(plan.base)
    , parent_frame_(plan.parent_frame.size(), Quat::Identity())
    , sag_simulator_(plan)
{
}

Plant const& Grower::grow(PlantKey const& key, double age, std::stop_token const& stop)
{
    CHECK(age >= 0 && age <= 1);
    GrowthNoise const noise(key);
    if (age < 1 || is_aged_)
        age_plant(age);
    for_each_level(plan_.levels, [&](std::span<AxisId const> axes) {
        GrowthBundle bundle(plan_, noise, age, { plant_.node_position_mm, parent_frame_ });
        for (; !axes.empty() && !stop.stop_requested();
             axes = axes.subspan(std::min(axes.size(), kGrowthLanes)))
            bundle.grow(axes.first(std::min(axes.size(), kGrowthLanes)));
    });
    if (stop.stop_requested())
        return plant_;
    if (plan_.parameters.sag > 0)
        sag_simulator_.sag(plant_, parent_frame_, stop);
    if (stop.stop_requested())
        return plant_;
    carry_organs(plan_, parent_frame_, plant_);
    if (age < 1)
        young_leaves_->place(plant_, age);
    carry_sections(plan_, parent_frame_, plant_);
    carry_polygons(plan_, parent_frame_, age, plant_);
    return plant_;
}

// Sets the radii of all nodes and the sizes of all organs to those at an age of the plant.
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
                    * static_cast<float>(maturity(age, axis_age.birth_at(along_mm)));
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

} // namespace tractus::variation
