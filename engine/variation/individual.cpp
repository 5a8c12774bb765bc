#include "engine/variation/individual.h"

#include "engine/base/check.h"
#include "engine/base/random.h"
#include "engine/plant/join_plants.h"
#include "engine/stroke/frames.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace tractus::variation {

namespace {

constexpr std::uint32_t kWhole = 0x696E6400; // Random stream of the plants' sizes and rotations.
// Random stream of missing and duplicated branches; fate_of() mixes the axis number into the seed.
constexpr std::uint32_t kBranches = 0x696E6401;
constexpr std::uint32_t kAges = 0x696E6402;   // Random stream of the plants' ages.
constexpr std::uint32_t kOrgans = 0x696E6403; // Random stream of the sizes of organs.
constexpr std::uint32_t kSeeds = 0x696E6404;  // Random stream that decides has_own_seed().

// What happens to a lateral branch in one plant of a collection.
struct Fate {
    bool is_lost = false;
    bool is_doubled = false;
    int away = 0; // Distance from the original, in segments of the parent axis.
    // Rotation of the duplicate about the parent axis, from the original's position.
    double turned_rad = 0;
};

Fate fate_of(AxisId id, PlantKey const& key, double share)
{
    // The axis number goes into the seed: a RandomKey has only one substream, which the plant's
    // index takes.
    Random random(
        { key.seed ^ (static_cast<std::uint64_t>(id) << 32), kBranches, key.plant_index });
    double const chance = random.uniform();
    Fate fate;
    fate.is_lost = chance < share;
    fate.is_doubled = chance >= 1 - share;
    fate.away = static_cast<int>(random.next_u32() % 5) - 2;
    fate.turned_rad = random.uniform(0.25, 0.75) * 2 * kPi;
    return fate;
}

Vec3 direction_of(Plant const& plant, Axis const& axis, SegmentId segment)
{
    auto const node = axis.first_node + (segment - axis.first_segment);
    Vec3 const step = plant.node_position_mm[node + 1] - plant.node_position_mm[node];
    double const length = step.norm();
    return length > 0 ? Vec3(step / length) : Vec3(Vec3::UnitZ());
}

NodeId tip_of(Axis const& axis, SegmentId segment)
{
    return axis.first_node + (segment - axis.first_segment) + 1;
}

// Indices of axes, organs or polygons, grouped by the axis or segment to which each is attached.
class Groups {
public:
    template<typename Things, typename GroupOf>
    Groups(std::size_t group_count, Things const& things, GroupOf const& group_of)
        : begins_(group_count + 1)
    {
        for (auto const& thing : things)
            if (group_of(thing) < group_count)
                ++begins_[group_of(thing) + 1];
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        indices_.resize(begins_.back());
        auto next = begins_;
        for (std::size_t i = 0; i < things.size(); ++i)
            if (group_of(things[i]) < group_count)
                indices_[next[group_of(things[i])]++] = i;
    }

    std::span<std::size_t const> of(std::size_t group) const
    {
        return std::span(indices_).subspan(begins_[group], begins_[group + 1] - begins_[group]);
    }

private:
    // Index in indices_ of each group's first element, followed by the number of all elements.
    std::vector<std::size_t> begins_;
    std::vector<std::size_t> indices_;
};

// Duplicates branches of a plant. add() must be called for axes in ascending order. No copy
// contains other copies, since only axes of the original plant are copied.
class Doubler {
public:
    explicit Doubler(Plant& plant)
        : plant_(plant)
        , laterals_(plant.axes.size(), plant.axes,
                    [](Axis const& axis) { return axis.parent_axis; })
        , organs_(plant.segment_count(), plant.organs,
                  [](auto const& organ) { return organ.segment; })
        , polygons_(plant.segment_count(), plant.polygons,
                    [](auto const& polygon) { return polygon.segment; })
        , copy_of_segment_(plant.segment_count(), kNone)
    {
    }

    void add(AxisId id, Fate const& fate)
    {
        auto const root = plant_.axes[id];
        auto const bearer = plant_.axes[root.parent_axis];
        auto const place = static_cast<std::int64_t>(root.parent_segment) + fate.away;
        std::int64_t const first = bearer.first_segment;
        auto const seat = static_cast<SegmentId>(
            std::clamp(place, first, first + static_cast<std::int64_t>(bearer.segment_count) - 1));
        from_mm_ = plant_.node_position_mm[tip_of(bearer, root.parent_segment)];
        to_mm_ = plant_.node_position_mm[tip_of(bearer, seat)];
        Vec3 const along = direction_of(plant_, bearer, seat);
        turn_ = Quat(Eigen::AngleAxisd(fate.turned_rad, along))
            * least_rotation(direction_of(plant_, bearer, root.parent_segment), along);
        find_branch(id);
        for (auto const axis : branch_)
            copy_axis(plant_.axes[axis], axis == id ? seat : kNone, root.parent_axis);
        copy_organs();
        copy_polygons();
    }

private:
    Vec3 moved(Vec3 const& place_mm) const { return to_mm_ + turn_ * (place_mm - from_mm_); }

    // Lists in branch_ the axes of a branch, in ascending order, so that parents come before their
    // laterals.
    void find_branch(AxisId id)
    {
        branch_.assign(1, id);
        for (std::size_t i = 0; i < branch_.size(); ++i)
            for (auto const lateral : laterals_.of(branch_[i]))
                branch_.push_back(static_cast<AxisId>(lateral));
        std::sort(branch_.begin(), branch_.end());
    }

    // Lists the organs or polygons on the segments of the branch in branch_, in ascending order.
    std::vector<std::size_t> const& on_branch(Groups const& by_segment)
    {
        found_.clear();
        for (auto const id : branch_)
            for (std::uint32_t i = 0; i < plant_.axes[id].segment_count; ++i) {
                auto const group = by_segment.of(plant_.axes[id].first_segment + i);
                found_.insert(found_.end(), group.begin(), group.end());
            }
        std::sort(found_.begin(), found_.end());
        return found_;
    }

    void copy_axis(Axis axis, SegmentId seat, AxisId bearer)
    {
        auto const from = axis;
        axis.first_node = static_cast<NodeId>(plant_.node_position_mm.size());
        axis.first_segment = static_cast<SegmentId>(plant_.segment_count());
        axis.parent_segment = seat != kNone ? seat : copy_of_segment_[from.parent_segment];
        axis.parent_axis = seat != kNone ? bearer : axis_of(plant_, axis.parent_segment);
        for (NodeId i = 0; i <= from.segment_count; ++i) {
            auto const node = from.first_node + i;
            plant_.node_position_mm.push_back(moved(plant_.node_position_mm[node]));
            plant_.node_radius_mm.push_back(plant_.node_radius_mm[node]);
            if (!plant_.node_section.empty()) {
                auto section = plant_.node_section[node];
                section.normal = turn_.cast<float>() * section.normal;
                plant_.node_section.push_back(section);
            }
        }
        for (std::uint32_t i = 0; i < from.segment_count; ++i) {
            copy_of_segment_[from.first_segment + i] = axis.first_segment + i;
            plant_.segment_material.push_back(plant_.segment_material[from.first_segment + i]);
        }
        plant_.axes.push_back(axis);
    }

    void copy_organs()
    {
        for (auto const i : on_branch(organs_)) {
            auto organ = plant_.organs[i];
            organ.segment = copy_of_segment_[organ.segment];
            organ.position_mm = moved(organ.position_mm);
            organ.orientation = (turn_ * organ.orientation).normalized();
            plant_.organs.push_back(std::move(organ));
        }
    }

    void copy_polygons()
    {
        for (auto const i : on_branch(polygons_)) {
            auto polygon = plant_.polygons[i];
            polygon.segment = copy_of_segment_[polygon.segment];
            auto const first = polygon.first_vertex;
            polygon.first_vertex = static_cast<std::uint32_t>(plant_.polygon_vertices_mm.size());
            for (std::uint32_t n = 0; n < polygon.vertex_count; ++n) {
                Vec3 const vertex_mm = moved(plant_.polygon_vertices_mm[first + n]);
                plant_.polygon_vertices_mm.push_back(vertex_mm);
            }
            plant_.polygons.push_back(polygon);
        }
    }

    Plant& plant_;
    Groups laterals_; // Axes, grouped by parent axis.
    Groups organs_;   // Organs, grouped by segment.
    Groups polygons_; // Polygons, grouped by segment.
    // For each segment, its latest copy; kNone if it has not been copied.
    std::vector<SegmentId> copy_of_segment_;
    Vec3 from_mm_ = Vec3::Zero();
    Vec3 to_mm_ = Vec3::Zero();
    Quat turn_ = Quat::Identity();
    std::vector<AxisId> branch_ {};     // Axes of the branch that add() is copying.
    std::vector<std::size_t> found_ {}; // Result of on_branch().
};

void resize(Plant& plant, double scale)
{
    auto const factor = static_cast<float>(scale);
    for (auto& node_mm : plant.node_position_mm)
        node_mm *= scale;
    for (auto& radius_mm : plant.node_radius_mm)
        radius_mm *= factor;
    for (auto& organ : plant.organs) {
        organ.position_mm *= scale;
        organ.scale *= factor;
    }
    for (auto& vertex_mm : plant.polygon_vertices_mm)
        vertex_mm *= scale;
}

// Scales organs about their points of attachment, and polygons, which are leaves, about their first
// vertices.
void resize_organs(Plant& plant, double scale)
{
    for (auto& organ : plant.organs)
        organ.scale *= static_cast<float>(scale);
    for (auto const& polygon : plant.polygons) {
        auto const first = plant.polygon_vertices_mm.begin() + polygon.first_vertex;
        Vec3 const base_mm = *first;
        for (std::uint32_t i = 1; i < polygon.vertex_count; ++i)
            first[i] = base_mm + scale * (first[i] - base_mm);
    }
}

Plant other_branches(Plant const& grown, PlantKey const& key, double share,
                     std::vector<bool> const& kept)
{
    Plant plant = grown;
    Doubler doubler(plant);
    std::vector<bool> is_lost(grown.segment_count());
    for (AxisId id = 0; id < grown.axes.size(); ++id) {
        auto const& axis = grown.axes[id];
        if (axis.parent_segment == kNone)
            continue;
        auto const fate = fate_of(id, key, share);
        if (fate.is_doubled)
            doubler.add(id, fate);
        if (fate.is_lost && !kept[id])
            is_lost[axis.first_segment] = true;
    }
    is_lost.resize(plant.segment_count());
    Plant shown;
    append_part(shown, plant, {}, is_lost);
    return shown;
}

} // namespace

std::vector<bool> axes_below_paths(Plant const& plant,
                                   std::vector<std::vector<SegmentId>> const& paths)
{
    std::vector<bool> is_below(plant.axes.size());
    for (auto const& path : paths)
        for (auto const segment : path)
            is_below[axis_of(plant, segment)] = true;
    // A plant lists parents before laterals, so the reverse order goes from the tips to the ground.
    for (AxisId id = static_cast<AxisId>(plant.axes.size()); id-- > 0;)
        if (is_below[id] && plant.axes[id].parent_axis != kNone)
            is_below[plant.axes[id].parent_axis] = true;
    return is_below;
}

double individual_age(PlantKey const& key, Individuality const& how, double age)
{
    return age * (1 - how.age * Random({ key.seed, kAges, key.plant_index }).uniform());
}

bool has_own_seed(PlantKey const& key, Individuality const& how)
{
    return Random({ key.seed, kSeeds, key.plant_index }).uniform() < how.seeds;
}

// Returns the maximum relative change in size of a plant: `size` times a factor, which is 1 for
// wide plants and up to kNarrowSize for narrow ones; at most kMaxSize.
static double size_range(Plant const& plant, double size)
{
    auto const box = bounds(plant);
    if (box.empty())
        return size;
    Vec3 const extent_mm = box.max_mm - box.min_mm;
    double const width_mm = extent_mm.head<2>().maxCoeff();
    double const narrow = width_mm < extent_mm.z() ? 1 - width_mm / extent_mm.z() : 0;
    return std::min(kMaxSize, size * (1 + (kNarrowSize - 1) * narrow));
}

// Returns the plant with its individual size and rotation. `size`: size_range() of the plant before
// branches were removed.
static Plant sized_and_turned(Plant const& grown, double size, PlantKey const& key,
                              Individuality const& how)
{
    Random random({ key.seed, kWhole, key.plant_index });
    double const scale = 1 + size * random.uniform(-1, 1);
    double const turn_rad = how.turn * random.uniform() * 2 * kPi;
    Plant plant = grown;
    if (how.size > 0)
        resize(plant, scale);
    if (how.organs > 0)
        resize_organs(
            plant, 1 + how.organs * Random({ key.seed, kOrgans, key.plant_index }).uniform(-1, 1));
    if (!(how.turn > 0))
        return plant;
    Plant turned;
    append_part(turned, plant, { .turn = Quat(Eigen::AngleAxisd(turn_rad, Vec3::UnitZ())) });
    return turned;
}

Plant individual(Plant const& grown, PlantKey const& key, Individuality const& how,
                 std::vector<bool> const& kept)
{
    CHECK(kept.size() == grown.axes.size());
    double const size = size_range(grown, how.size);
    if (!(how.branches > 0))
        return sized_and_turned(grown, size, key, how);
    return sized_and_turned(other_branches(grown, key, how.branches, kept), size, key, how);
}

Plant comparable_individual(Plant const& grown, PlantKey const& key, Individuality const& how,
                            std::vector<bool> const& kept)
{
    CHECK(kept.size() == grown.axes.size());
    double const size = size_range(grown, how.size);
    if (!(how.branches > 0))
        return sized_and_turned(grown, size, key, how);
    Plant plant = grown;
    std::vector<bool> is_lost(plant.axes.size());
    for (AxisId id = 0; id < plant.axes.size(); ++id) { // Parents come before laterals.
        auto const& axis = plant.axes[id];
        if (axis.parent_segment == kNone)
            continue;
        is_lost[id]
            = is_lost[axis.parent_axis] || (!kept[id] && fate_of(id, key, how.branches).is_lost);
        if (!is_lost[id])
            continue;
        auto const seat = tip_of(plant.axes[axis.parent_axis], axis.parent_segment);
        Vec3 const seat_mm = plant.node_position_mm[seat];
        std::fill_n(plant.node_position_mm.begin() + axis.first_node, axis.segment_count + 1,
                    seat_mm);
    }
    return sized_and_turned(plant, size, key, how);
}

} // namespace tractus::variation
