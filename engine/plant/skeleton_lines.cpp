#include "engine/plant/skeleton_lines.h"

#include "engine/plant/measured_plant.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <unordered_map>
#include <utility>

namespace tractus {

namespace {

// A joint of the skeleton, and the joints to which lines connect it.
struct SkeletonJoint {
    Vec3 place_mm;
    std::vector<std::uint32_t> neighbours;
};

// Finds or adds the joint at a position, with a hash grid whose cells have the size of the
// tolerance.
class JointFinder {
public:
    explicit JointFinder(double tolerance_mm)
        : tolerance_mm_(std::max(tolerance_mm, std::numeric_limits<double>::min()))
    {
    }

    std::uint32_t at(Vec3 const& place_mm)
    {
        Cell const cell = cell_of(place_mm);
        for (std::int64_t x = -1; x <= 1; ++x)
            for (std::int64_t y = -1; y <= 1; ++y)
                for (std::int64_t z = -1; z <= 1; ++z) {
                    auto const found = cells_.find({ cell[0] + x, cell[1] + y, cell[2] + z });
                    if (found == cells_.end())
                        continue;
                    for (auto const number : found->second)
                        if ((joints[number].place_mm - place_mm).norm() <= tolerance_mm_)
                            return number;
                }
        auto const number = static_cast<std::uint32_t>(joints.size());
        joints.push_back({ place_mm, {} });
        cells_[cell].push_back(number);
        return number;
    }

    std::vector<SkeletonJoint> joints;

private:
    using Cell = std::array<std::int64_t, 3>;
    struct Hash {
        std::size_t operator()(Cell const& cell) const
        {
            std::uint64_t hash = 0;
            for (auto const part : cell)
                hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15;
            return hash ^ (hash >> 32);
        }
    };

    Cell cell_of(Vec3 const& place_mm) const
    {
        // Positions beyond this number of cells are clamped to the outermost cells.
        constexpr double kFarthest = 0x1p62;
        Vec3 const cell = (place_mm / tolerance_mm_).array().floor().max(-kFarthest).min(kFarthest);
        return { static_cast<std::int64_t>(cell.x()), static_cast<std::int64_t>(cell.y()),
                 static_cast<std::int64_t>(cell.z()) };
    }

    double tolerance_mm_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

// The joints as a forest: the parent of each joint, and the length of its longest path to a tip.
class Forest {
public:
    explicit Forest(std::vector<SkeletonJoint> const& joints)
        : joints_(joints)
        , below_(joints.size(), kNone)
        , reach_mm_(joints.size())
        , children_(joints.size())
    {
        find_roots();
        for (auto joint = order_.rbegin(); joint != order_.rend(); ++joint)
            if (auto const below = below_[*joint]; below != *joint) {
                double const step_mm = (joints[*joint].place_mm - joints[below].place_mm).norm();
                reach_mm_[below] = std::max(reach_mm_[below], reach_mm_[*joint] + step_mm);
                children_[below].push_back(*joint);
            }
        for (std::uint32_t joint = 0; joint < joints_.size(); ++joint)
            sort_children(joint);
    }

    Plant plant() const;

private:
    // Sorts the children of a joint by the length of their path to a tip, longest first; of equally
    // long ones, up to rounding, the straightest comes first.
    void sort_children(std::uint32_t joint)
    {
        auto& children = children_[joint];
        if (children.size() < 2)
            return;
        Vec3 const before = joints_[joint].place_mm - joints_[below_[joint]].place_mm;
        double longest_mm = 0;
        for (auto const child : children)
            longest_mm = std::max(longest_mm, way_mm(joint, child));
        auto const rank = [&](std::uint32_t child) {
            Vec3 const step = joints_[child].place_mm - joints_[joint].place_mm;
            double const length = std::round(way_mm(joint, child) / longest_mm * 1e6);
            return std::pair(-length, -before.dot(step) / step.norm());
        };
        std::stable_sort(children.begin(), children.end(),
                         [&](auto a, auto b) { return rank(a) < rank(b); });
    }

    double way_mm(std::uint32_t joint, std::uint32_t child) const
    {
        return (joints_[child].place_mm - joints_[joint].place_mm).norm() + reach_mm_[child];
    }

    // Roots each connected part at its lowest joint. The traversal is breadth first, so that a loop
    // is cut where the two paths around it meet.
    void find_roots()
    {
        std::vector<std::uint32_t> lowest_first(joints_.size());
        for (std::uint32_t i = 0; i < joints_.size(); ++i)
            lowest_first[i] = i;
        std::stable_sort(lowest_first.begin(), lowest_first.end(), [&](auto a, auto b) {
            return joints_[a].place_mm.z() < joints_[b].place_mm.z();
        });
        for (auto const root : lowest_first) {
            if (below_[root] != kNone)
                continue;
            below_[root] = root;
            roots_.push_back(root);
            auto next = order_.size();
            order_.push_back(root);
            for (; next < order_.size(); ++next)
                for (auto const neighbour : joints_[order_[next]].neighbours)
                    if (below_[neighbour] == kNone) {
                        below_[neighbour] = order_[next];
                        order_.push_back(neighbour);
                    }
        }
    }

    std::vector<SkeletonJoint> const& joints_;
    std::vector<std::uint32_t> below_; // Parent of each joint. A root is its own parent.
    std::vector<double> reach_mm_;
    // Children of each joint, the one with the longest path to a tip first.
    std::vector<std::vector<std::uint32_t>> children_;
    std::vector<std::uint32_t> roots_;
    std::vector<std::uint32_t> order_;
};

Plant Forest::plant() const
{
    struct Start {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        SegmentId parent_segment = kNone;
        AxisId parent_axis = kNone;
    };
    Plant plant;
    plant.materials = { Material {} };
    std::vector<Start> starts;
    for (auto const root : roots_)
        for (auto const child : children_[root])
            starts.push_back({ root, child });
    for (std::size_t i = 0; i < starts.size(); ++i) { // The body appends laterals to the list.
        auto const start = starts[i];
        Axis axis { .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                    .first_segment = static_cast<SegmentId>(plant.segment_count()),
                    .parent_segment = start.parent_segment,
                    .parent_axis = start.parent_axis,
                    .order
                    = start.parent_axis == kNone ? 0 : plant.axes[start.parent_axis].order + 1 };
        auto const id = static_cast<AxisId>(plant.axes.size());
        plant.node_position_mm.push_back(joints_[start.from].place_mm);
        for (auto joint = start.to;; joint = children_[joint].front()) {
            plant.node_position_mm.push_back(joints_[joint].place_mm);
            plant.segment_material.push_back(0);
            ++axis.segment_count;
            auto const segment = static_cast<SegmentId>(plant.segment_count() - 1);
            for (std::size_t lateral = 1; lateral < children_[joint].size(); ++lateral)
                starts.push_back({ joint, children_[joint][lateral], segment, id });
            if (children_[joint].empty())
                break;
        }
        plant.axes.push_back(axis);
    }
    plant.node_radius_mm.resize(plant.node_position_mm.size());
    return plant;
}

} // namespace

Result<Plant> plant_from_lines(std::string const& name, std::span<SkeletonPiece const> lines,
                               SkeletonOptions const& options)
{
    Bounds box;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].from_mm.allFinite() || !lines[i].to_mm.allFinite())
            return fail(Fault::User,
                        fmt::format("{}: an end of line {} is not a number: export the skeleton "
                                    "again",
                                    name, i + 1));
        box.add(lines[i].from_mm);
        box.add(lines[i].to_mm);
    }
    TRY(check_size(name, box));
    double const extent_mm = box.empty() ? 0 : (box.max_mm - box.min_mm).maxCoeff();
    JointFinder finder(options.tolerance * extent_mm);
    for (auto const& line : lines) {
        auto const from = finder.at(line.from_mm);
        auto const to = finder.at(line.to_mm);
        auto& neighbours = finder.joints[from].neighbours;
        if (from == to || std::find(neighbours.begin(), neighbours.end(), to) != neighbours.end())
            continue;
        neighbours.push_back(to);
        finder.joints[to].neighbours.push_back(from);
    }
    auto plant = Forest(finder.joints).plant();
    if (plant.axes.empty())
        return fail(Fault::User,
                    fmt::format("{}: there is no line with a length that could be a branch", name));
    Vec3 const base_mm = plant.node_position_mm.front();
    for (auto& node : plant.node_position_mm)
        node -= base_mm;
    double const height_mm = std::max(box.max_mm.z() - box.min_mm.z(), 1e-3 * extent_mm);
    apply_pipe_model(plant, 2, options.tip_radius * height_mm);
    return plant;
}

} // namespace tractus
