#include "engine/variation/young_leaves.h"

#include "engine/base/parallel.h"
#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace tractus::variation {

namespace {

// Random stream that decides which leaves sprout early, and how far behind an apex they sit.
constexpr std::uint32_t kLeafStream = 0x796C;
constexpr std::size_t kLeavesAtOnce = 2048;
// Number of leaves on a growing shoot, as a multiple of the mean number on a full-grown twig.
constexpr double kShare = 1.5;
// Maximum distance of a leaf behind an apex, as a share of the twigs' mean length.
constexpr double kReach = 0.6;

bool is_leaf(Plant const& plant, Organ const& organ)
{
    auto const material = plant.organ_shapes[organ.shape].material;
    return organ.segment != kNone && plant.materials[material].kind == Material::Kind::Leaf;
}

// Rank of a leaf: a random number, then the organ's number. Leaves of lower rank sprout earlier.
using Rank = std::pair<std::uint32_t, std::uint32_t>;

} // namespace

YoungLeaves::YoungLeaves(GrowthPlan const& plan)
    : plan_(plan)
{
    for (auto const& organ : plan.organs)
        sprout_.push_back(organ.birth);
    end_mm_.resize(plan.segments.size());
    for (auto const& axis : plan.base.axes) {
        double along_mm = 0;
        for (auto s = axis.first_segment; s < axis.first_segment + axis.segment_count; ++s)
            end_mm_[s] = along_mm += plan.segments[s].length_mm;
    }
    find_leaves();
    find_sprouts();
}

void YoungLeaves::find_leaves()
{
    auto const& base = plan_.base;
    std::vector<bool> bears(base.axes.size());
    for (std::uint32_t i = 0; i < base.organs.size(); ++i) {
        auto const& organ = base.organs[i];
        if (!is_leaf(base, organ))
            continue;
        auto const axis = axis_of(base, organ.segment);
        leaves_.push_back({ i, axis, end_mm_[organ.segment], 0 });
        bears[axis] = true;
    }
    if (leaves_.empty())
        return;
    std::size_t twigs = 0;
    double length_mm = 0;
    for (AxisId id = 0; id < bears.size(); ++id)
        if (bears[id]) {
            ++twigs;
            length_mm += plan_.axis_length_mm[id];
        }
    auto const count = static_cast<double>(leaves_.size());
    per_shoot_ = static_cast<std::size_t>(std::ceil(kShare * count / static_cast<double>(twigs)));
    double const reach_mm = kReach * length_mm / static_cast<double>(twigs);
    for (auto& leaf : leaves_)
        leaf.behind_mm = reach_mm * 0x1p-32
            * random_block({ .seed = 0, .stream = kLeafStream }, leaf.organ)[1];
}

// Finds the leaves that sprout when an axis begins to grow. They are the per_shoot_ leaves of
// lowest rank among those that the axis and its descendants will have in the end.
void YoungLeaves::find_sprouts()
{
    auto const& axes = plan_.base.axes;
    std::vector<std::vector<Rank>> first(axes.size());
    for (auto const& leaf : leaves_)
        first[leaf.axis].emplace_back(
            random_block({ .seed = 0, .stream = kLeafStream }, leaf.organ)[0], leaf.organ);
    // A plant lists parents before laterals, so the reverse order goes from the tips to the ground.
    for (AxisId id = static_cast<AxisId>(axes.size()); id-- > 0;) {
        auto ranks = std::exchange(first[id], {});
        auto const count = std::min(ranks.size(), per_shoot_);
        std::partial_sort(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(count),
                          ranks.end());
        ranks.resize(count);
        for (auto const& [rank, organ] : ranks)
            sprout_[organ] = std::min(sprout_[organ], plan_.axes[id].age.begin);
        if (auto const parent = axes[id].parent_axis; parent != kNone)
            first[parent].insert(first[parent].end(), ranks.begin(), ranks.end());
    }
}

void YoungLeaves::place(Plant& plant, double age) const
{
    parallel_for(leaves_.size(), kLeavesAtOnce, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i != end; ++i) {
            auto const& leaf = leaves_[i];
            if (sprout_[leaf.organ] >= age)
                continue;
            auto const seat = plan_.organs[leaf.organ].seat.node;
            plant.organs[leaf.organ].position_mm
                += point_behind_apex(plant, leaf, age) - plant.node_position_mm[seat];
        }
    });
}

// Returns the position of a leaf behind the apex of a growing axis: that of the leaf itself, or its
// nearest ancestor that has begun to grow.
Vec3 YoungLeaves::point_behind_apex(Plant const& plant, Leaf const& leaf, double age) const
{
    auto const& axes = plan_.base.axes;
    auto axis = leaf.axis;
    while (plan_.axes[axis].age.begin >= age && axes[axis].parent_axis != kNone)
        axis = axes[axis].parent_axis;
    // After the skeleton is complete, leaves approach the apex, from behind_mm to 0 at age 1.
    double const left = std::clamp((1 - age) / (1 - kSkeletonShare), 0.0, 1.0);
    double along_mm = plan_.axes[axis].age.along_at_mm(age) - left * leaf.behind_mm;
    if (axis == leaf.axis)
        along_mm = std::min(along_mm, leaf.along_mm);
    while (along_mm < 0 && axes[axis].parent_axis != kNone) {
        along_mm += end_mm_[axes[axis].parent_segment];
        axis = axes[axis].parent_axis;
    }
    return point_on(plant, axis, std::max(along_mm, 0.0));
}

Vec3 YoungLeaves::point_on(Plant const& plant, AxisId id, double along_mm) const
{
    auto const& axis = plan_.base.axes[id];
    auto const ends = std::span(end_mm_).subspan(axis.first_segment, axis.segment_count);
    auto const found = std::lower_bound(ends.begin(), ends.end(), along_mm);
    auto const i = std::min(static_cast<std::size_t>(found - ends.begin()),
                            axis.segment_count - std::size_t(1));
    auto const nodes = plant.positions(axis).subspan(i, 2);
    // Length of the segment's part that has grown.
    double const length_mm = (nodes[1] - nodes[0]).norm();
    double const into_mm = along_mm - (ends[i] - plan_.segments[axis.first_segment + i].length_mm);
    if (into_mm >= length_mm)
        return nodes[1];
    return nodes[0] + std::max(into_mm, 0.0) / length_mm * (nodes[1] - nodes[0]);
}

} // namespace tractus::variation
