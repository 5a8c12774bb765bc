#include "engine/mesh/level_of_detail.h"

#include "engine/base/check.h"
#include "engine/base/random.h"
#include "engine/mesh/mesh_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tractus::mesh {

namespace {

// Random streams for the order in which twigs, organs and polygons are removed.
constexpr std::uint32_t kTwigs = 0x7477;
constexpr std::uint32_t kOrgans = 0x6F72;
constexpr std::uint32_t kPolygons = 0x706F;

// Detail smaller than this share of the plant's size counts as invisible in a plant with all
// triangles. For a coarser plant, which is displayed smaller, it is divided by the square root of
// the share of triangles.
constexpr double kUnseen = 0.001;
// Maximum number of segments that one straight segment may replace.
constexpr std::uint32_t kLongestRun = 16;
constexpr int kRounds = 4; // Maximum number of iterations in the search for the axes to keep.

double chance(std::uint32_t stream, std::size_t index)
{
    return random_block({ .stream = stream }, index)[0] / 0x1p32;
}

// Returns the volume of the straight truncated cone between two nodes of an axis.
double volume_between(Plant const& plant, NodeId from, NodeId to)
{
    double const length = (plant.node_position_mm[to] - plant.node_position_mm[from]).norm();
    double const a = plant.node_radius_mm[from];
    double const b = plant.node_radius_mm[to];
    return kPi / 3 * length * (a * a + a * b + b * b);
}

double volume_of(Plant const& plant, Axis const& axis)
{
    double volume = 0;
    for (std::uint32_t i = 0; i < axis.segment_count; ++i)
        volume += volume_between(plant, axis.first_node + i, axis.first_node + i + 1);
    return volume;
}

std::vector<std::size_t> triangles_per_axis(Plant const& plant, MeshOptions const& options)
{
    std::vector<std::size_t> triangles(plant.axes.size());
    MeshPlan const plan(plant, options);
    for (auto const& surface : plan.surfaces())
        for (std::size_t i = 0; i < surface.tube_count; ++i) {
            auto const end = i + 1 < surface.items.size() ? surface.items[i + 1].first_index
                                                          : surface.extent.indices;
            triangles[surface.items[i].number] += (end - surface.items[i].first_index) / 3;
        }
    return triangles;
}

std::size_t tube_triangles(Plant const& plant, MeshOptions const& options)
{
    auto const of_axes = triangles_per_axis(plant, options);
    return std::accumulate(of_axes.begin(), of_axes.end(), std::size_t { 0 });
}

// Returns all axes in order of importance: the last ones are removed first. Each axis comes after
// its parent.
std::vector<AxisId> order_of_staying(Plant const& plant)
{
    std::vector<double> worth(plant.axes.size());
    double most_volume = -1;
    AxisId trunk = kNone;
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        auto const* const radii = &plant.node_radius_mm[axis.first_node];
        double const radius = *std::max_element(radii, radii + axis.segment_count + 1);
        worth[id] = radius * std::exp2(chance(kTwigs, id));
        if (auto const volume = volume_of(plant, axis); volume > most_volume) {
            most_volume = volume;
            trunk = id;
        }
    }
    for (AxisId id = trunk; id != kNone; id = plant.axes[id].parent_axis)
        worth[id] = std::numeric_limits<double>::infinity();
    for (AxisId id = 0; id < plant.axes.size(); ++id)
        if (auto const parent = plant.axes[id].parent_axis; parent != kNone)
            worth[id] = std::min(worth[id], worth[parent]);
    std::vector<AxisId> order(plant.axes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](AxisId a, AxisId b) { return worth[a] > worth[b]; });
    return order;
}

// A plant reduced to some of its axes. `new_segment`: for each segment of the original plant, the
// segment that replaces it; the segments of a removed twig are replaced by the segment to which the
// twig was attached.
struct Branches {
    Plant plant;
    std::vector<SegmentId> new_segment;

    SegmentId now(SegmentId segment) const
    {
        return segment == kNone ? kNone : new_segment[segment];
    }
};

// Builds plants from subsets of another plant's axes.
class Coarsener {
public:
    Coarsener(Plant const& plant, double unseen_mm)
        : plant_(plant)
        , unseen_mm_(unseen_mm)
    {
    }

    // Returns the plant with the axes marked in `stays`; their parents must be marked, too.
    Branches branches(std::vector<char> const& stays);

private:
    bool is_needed(Axis const& axis, std::uint32_t node) const;
    bool runs_straight(NodeId from, NodeId to) const;
    void add_axis(Axis const& axis, Branches& to) const;

    Plant const& plant_;
    double unseen_mm_;
    std::vector<char> bears_; // For each segment: 1 if an axis that stays is attached to it.
};

// True if node number `node` of the axis, counted from its base, must stay wherever it is.
bool Coarsener::is_needed(Axis const& axis, std::uint32_t node) const
{
    if (node == 0 || node == axis.segment_count || has_contour(plant_, axis))
        return true;
    auto const before = axis.first_segment + node - 1;
    return bears_[before] || plant_.segment_material[before] != plant_.segment_material[before + 1];
}

// True if a straight tube from node `from` to node `to` runs through all nodes in between and has
// their radii, with errors of at most unseen_mm_.
bool Coarsener::runs_straight(NodeId from, NodeId to) const
{
    auto const& start = plant_.node_position_mm[from];
    Vec3 const way = plant_.node_position_mm[to] - start;
    double const length = way.norm();
    double last = 0;
    for (NodeId node = from + 1; node < to; ++node) {
        Vec3 const step = plant_.node_position_mm[node] - start;
        double const along = length > 0 ? step.dot(way) / length : 0;
        double const share = length > 0 ? along / length : 0;
        double const radius
            = (1 - share) * plant_.node_radius_mm[from] + share * plant_.node_radius_mm[to];
        double const aside = length > 0 ? (step - way * share).norm() : step.norm();
        if (along < last || along > length || aside > unseen_mm_
            || std::abs(radius - plant_.node_radius_mm[node]) > unseen_mm_)
            return false;
        last = along;
    }
    return true;
}

void Coarsener::add_axis(Axis const& axis, Branches& to) const
{
    auto& coarse = to.plant;
    auto now = axis;
    now.first_node = static_cast<NodeId>(coarse.node_position_mm.size());
    now.first_segment = static_cast<SegmentId>(coarse.segment_count());
    now.parent_segment = to.now(axis.parent_segment);
    auto const add_node = [&](std::uint32_t node) {
        coarse.node_position_mm.push_back(plant_.node_position_mm[axis.first_node + node]);
        coarse.node_radius_mm.push_back(plant_.node_radius_mm[axis.first_node + node]);
        if (!plant_.node_section.empty())
            coarse.node_section.push_back(plant_.node_section[axis.first_node + node]);
    };
    add_node(0);
    for (std::uint32_t from = 0; from < axis.segment_count;) {
        auto next = from + 1;
        while (!is_needed(axis, next) && next - from < kLongestRun
               && runs_straight(axis.first_node + from, axis.first_node + next + 1))
            ++next;
        add_node(next);
        std::fill_n(&to.new_segment[axis.first_segment + from], next - from,
                    static_cast<SegmentId>(coarse.segment_count()));
        coarse.segment_material.push_back(plant_.segment_material[axis.first_segment + from]);
        from = next;
    }
    now.segment_count = static_cast<std::uint32_t>(coarse.segment_count() - now.first_segment);
    coarse.axes.push_back(now);
}

Branches Coarsener::branches(std::vector<char> const& stays)
{
    Branches made;
    auto& coarse = made.plant;
    coarse.materials = plant_.materials;
    coarse.organ_shapes = plant_.organ_shapes;
    coarse.contours = plant_.contours;
    coarse.root_flare = plant_.root_flare;
    bears_.assign(plant_.segment_count(), 0);
    for (AxisId id = 0; id < plant_.axes.size(); ++id)
        if (stays[id] && plant_.axes[id].parent_segment != kNone)
            bears_[plant_.axes[id].parent_segment] = 1;
    made.new_segment.assign(plant_.segment_count(), kNone);
    std::vector<AxisId> new_axis(plant_.axes.size(), kNone);
    for (AxisId id = 0; id < plant_.axes.size(); ++id) {
        auto const& axis = plant_.axes[id];
        // What is attached to a removed axis moves to the segment that carried the axis.
        if (!stays[id]) {
            std::fill_n(&made.new_segment[axis.first_segment], axis.segment_count,
                        made.now(axis.parent_segment));
            continue;
        }
        new_axis[id] = static_cast<AxisId>(coarse.axes.size());
        add_axis(axis, made);
        auto& parent = coarse.axes.back().parent_axis;
        parent = parent == kNone ? kNone : new_axis[parent];
    }
    return made;
}

// Thickens all axes except the one of greatest volume by a common factor, so that the total volume
// is `volume`.
void keep_volume(Plant& coarse, double volume)
{
    std::vector<double> volumes;
    for (auto const& axis : coarse.axes)
        volumes.push_back(volume_of(coarse, axis));
    if (volumes.empty())
        return;
    auto const trunk = static_cast<std::size_t>(std::max_element(volumes.begin(), volumes.end())
                                                - volumes.begin());
    double const others = std::accumulate(volumes.begin(), volumes.end(), 0.0) - volumes[trunk];
    if (!(others > 0))
        return;
    double const growth = std::sqrt(std::max(1.0, (volume - volumes[trunk]) / others));
    for (std::size_t i = 0; i < coarse.axes.size(); ++i) {
        auto const& axis = coarse.axes[i];
        for (std::uint32_t k = 0; i != trunk && k <= axis.segment_count; ++k)
            coarse.node_radius_mm[axis.first_node + k] *= static_cast<float>(growth);
    }
}

// Returns the plant with as many of its axes as have nearly, but at most, `budget` triangles.
Branches coarser_branches(Plant const& plant, Coarsener& coarsener, MeshOptions const& options,
                          double budget)
{
    double volume = 0;
    for (auto const& axis : plant.axes)
        volume += volume_of(plant, axis);
    auto const order = order_of_staying(plant);
    auto const costs = triangles_per_axis(plant, options);

    Branches best;
    std::size_t best_count = 0;
    double within = budget;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<char> stays(plant.axes.size(), 0);
        std::size_t count = 0;
        double sum = 0;
        for (auto const id : order) {
            sum += static_cast<double>(costs[id]);
            if (count > 0 && sum > within)
                break;
            stays[id] = 1;
            ++count;
        }
        auto coarse = coarsener.branches(stays);
        keep_volume(coarse.plant, volume);
        auto const triangles = static_cast<double>(tube_triangles(coarse.plant, options));
        if (round == 0 || (triangles <= budget && count > best_count)) {
            best = std::move(coarse);
            best_count = count;
        }
        if (triangles <= budget && (count == plant.axes.size() || triangles > 0.95 * budget))
            break;
        // The estimate is corrected: axes have fewer triangles than in the full plant where nodes
        // were removed, and more where axes were thickened.
        within *= 0.98 * budget / std::max(triangles, 1.0);
    }
    return best;
}

// Chooses a share of `things` (indices of organs or polygons), namely those with the smallest
// random numbers, and returns them in ascending order.
std::vector<std::size_t> those_that_stay(std::span<std::size_t const> things, std::uint32_t stream,
                                         double share)
{
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(things.size());
    for (auto const thing : things)
        order.emplace_back(chance(stream, thing), thing);
    auto const count = std::min(
        things.size(), static_cast<std::size_t>(share * static_cast<double>(things.size())));
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                     order.end());
    std::vector<std::size_t> staying;
    for (std::size_t i = 0; i < count; ++i)
        staying.push_back(order[i].second);
    std::sort(staying.begin(), staying.end());
    return staying;
}

// Returns the linear scale factor that gives the remaining organs or polygons, of area `staying`,
// the area `all`.
double growth_by_area(double all, double staying)
{
    return staying > 0 ? std::sqrt(all / staying) : 1;
}

double area_of(Organ const& organ)
{
    return std::abs(double { organ.scale.x() } * organ.scale.y());
}

void thin_organs(Plant const& plant, MeshOptions const& options, double share, CoarserOrgans organs,
                 Branches& coarse)
{
    auto const coarser = coarser_options(options, share);
    std::vector<std::vector<std::size_t>> of_shape(plant.organ_shapes.size());
    for (std::size_t i = 0; i < plant.organs.size(); ++i)
        of_shape[plant.organs[i].shape].push_back(i);
    // The index of each remaining organ and its scale factor.
    std::vector<std::pair<std::size_t, double>> staying;
    for (std::size_t shape = 0; shape < of_shape.size(); ++shape) {
        auto const& all = of_shape[shape];
        if (all.empty())
            continue;
        auto const id = static_cast<OrganShapeId>(shape);
        auto const full = make_prototype(plant, id, options).triangle_count();
        auto const cheap = make_prototype(plant, id, coarser).triangle_count();
        if (cheap == 0)
            continue;
        bool const keeps_all = organs == CoarserOrgans::KeepFew && all.size() <= kFewOrgans;
        auto const stay = those_that_stay(
            all, kOrgans,
            keeps_all ? 1 : share * static_cast<double>(full) / static_cast<double>(cheap));
        auto const area = [&](double sum, std::size_t i) { return sum + area_of(plant.organs[i]); };
        double const growth = growth_by_area(std::accumulate(all.begin(), all.end(), 0.0, area),
                                             std::accumulate(stay.begin(), stay.end(), 0.0, area));
        for (auto const i : stay)
            staying.emplace_back(i, growth);
    }
    std::sort(staying.begin(), staying.end());
    for (auto const& [i, growth] : staying) {
        auto& organ = coarse.plant.organs.emplace_back(plant.organs[i]);
        organ.segment = coarse.now(organ.segment);
        organ.scale *= static_cast<float>(growth);
    }
}

// Returns the area of a flat polygon.
double area_of(std::span<Vec3 const> corners)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    return sum.norm() / 2;
}

void thin_polygons(Plant const& plant, double share, Branches& coarse)
{
    auto const corners_of = [&](Polygon const& polygon) {
        return std::span(plant.polygon_vertices_mm)
            .subspan(polygon.first_vertex, polygon.vertex_count);
    };
    std::vector<std::size_t> all(plant.polygons.size());
    std::iota(all.begin(), all.end(), 0);
    auto const stay = those_that_stay(all, kPolygons, share);
    auto const area
        = [&](double sum, std::size_t i) { return sum + area_of(corners_of(plant.polygons[i])); };
    double const growth = growth_by_area(std::accumulate(all.begin(), all.end(), 0.0, area),
                                         std::accumulate(stay.begin(), stay.end(), 0.0, area));
    for (auto const i : stay) {
        auto const corners = corners_of(plant.polygons[i]);
        auto& polygon = coarse.plant.polygons.emplace_back(plant.polygons[i]);
        polygon.segment = coarse.now(polygon.segment);
        polygon.first_vertex = static_cast<std::uint32_t>(coarse.plant.polygon_vertices_mm.size());
        // The polygon is scaled about its first vertex, which is its point of attachment.
        for (auto const& corner : corners)
            coarse.plant.polygon_vertices_mm.push_back(corners[0] + growth * (corner - corners[0]));
    }
}

} // namespace

MeshOptions coarser_options(MeshOptions const& options, double share)
{
    CHECK(share > 0 && share <= 1);
    double const finer = std::sqrt(share);
    auto const fewer = [&](int count, int least) {
        return std::max(least, static_cast<int>(std::lround(count * finer)));
    };
    MeshOptions coarser = options;
    coarser.max_sides = fewer(options.max_sides, 3);
    coarser.min_sides = std::min(fewer(options.min_sides, 3), coarser.max_sides);
    coarser.subdivision = std::min(options.subdivision, fewer(options.subdivision, 1));
    coarser.sections = MeshOptions::Sections::SameArea;
    if (share <= 0.25) {
        coarser.ends = MeshOptions::Ends::Open;
        coarser.organs = MeshOptions::Organs::Cards;
    }
    return coarser;
}

Plant coarser_plant(Plant const& plant, MeshOptions const& options, double share,
                    CoarserOrgans organs)
{
    auto const coarser = coarser_options(options, share);
    auto const box = bounds(plant);
    double const size_mm = box.empty() ? 0 : (box.max_mm - box.min_mm).norm();
    Coarsener coarsener(plant, kUnseen * size_mm / std::sqrt(share));
    double const budget = share * static_cast<double>(tube_triangles(plant, options));
    auto coarse = coarser_branches(plant, coarsener, coarser, budget);
    thin_organs(plant, options, share, organs, coarse);
    thin_polygons(plant, share, coarse);
    return std::move(coarse.plant);
}

} // namespace tractus::mesh
