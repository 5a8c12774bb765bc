#include "engine/variation/limb_pattern.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tractus::variation {

namespace {

// Cost of a pattern for each branching order by which it differs from the limb, in units of the
// natural logarithm of the ratio of their lengths.
constexpr double kOrderCost = 0.25;

// Sine of the angle between a twig or organ and its axis below which it points along the axis and
// so gives the node no direction around it.
constexpr double kAlongAxis = 0.1;

// Maximum number of a limb's internodes, however short its pattern's internodes are.
constexpr double kMaxNodes = 2000;

// A node of the pattern that carries twigs or organs.
struct BearingNode {
    SegmentId segment = 0;
    // Direction of the node's twigs around the axis, measured from the frame's normal.
    double angle_rad = 0;
};

class BearingNodes {
public:
    BearingNodes(Plant const& plant, RestShape const& rest, AxisId pattern)
        : rest_(rest)
        , axis_(plant.axes[pattern])
        , side_(axis_.segment_count, Vec3::Zero())
        , bears_(axis_.segment_count)
    {
        for (auto const& twig : plant.axes)
            if (twig.parent_axis == pattern)
                add(twig.parent_segment,
                    plant.node_position_mm[twig.first_node + 1]
                        - plant.node_position_mm[twig.first_node]);
        for (auto const& organ : plant.organs)
            if (is_own(organ.segment))
                add(organ.segment, organ.orientation * Vec3::UnitY());
        for (auto const& polygon : plant.polygons)
            if (is_own(polygon.segment))
                add(polygon.segment,
                    plant.polygon_vertices_mm[polygon.first_vertex]
                        - plant.node_position_mm[nodes_of(plant, polygon.segment).tip]);
    }

    std::vector<BearingNode> list() const
    {
        std::vector<BearingNode> nodes;
        for (std::uint32_t i = 0; i < axis_.segment_count; ++i) {
            if (!bears_[i])
                continue;
            auto const& side = side_[i];
            nodes.push_back(
                { axis_.first_segment + i, side.isZero(0) ? 0 : std::atan2(side.z(), side.y()) });
        }
        return nodes;
    }

private:
    bool is_own(SegmentId segment) const
    {
        return segment != kNone && segment >= axis_.first_segment
            && segment - axis_.first_segment < axis_.segment_count;
    }

    // Notes a twig, organ or polygon at the end of `segment`. The first one that points away from
    // the axis gives the node's direction.
    void add(SegmentId segment, Vec3 const& direction)
    {
        auto const i = segment - axis_.first_segment;
        bears_[i] = true;
        Vec3 const local = rest_.frame[segment].conjugate() * direction;
        if (side_[i].isZero(0) && local.tail<2>().norm() > kAlongAxis * local.norm())
            side_[i] = local;
    }

    RestShape const& rest_;
    Axis const& axis_;
    // Direction of each node's twigs, in the frame of its segment; zero if there is none.
    std::vector<Vec3> side_;
    std::vector<bool> bears_;
};

// Returns the direction of node `number` around the axis. Nodes beyond the pattern's last one
// follow at the divergence angle found in the middle of the pattern.
double continued_angle_rad(std::vector<BearingNode> const& nodes, std::size_t number)
{
    if (number < nodes.size())
        return nodes[number].angle_rad;
    double divergence_rad = kPi;
    if (auto const middle = nodes.size() / 2; middle > 0)
        divergence_rad = nodes[middle].angle_rad - nodes[middle - 1].angle_rad;
    return nodes.back().angle_rad + static_cast<double>(number - nodes.size() + 1) * divergence_rad;
}

} // namespace

AxisId pattern_for_limb(Plant const& plant, RestShape const& rest, std::uint32_t order,
                        double length_mm)
{
    CHECK(!plant.axes.empty());
    std::uint32_t highest = 0;
    for (auto const& axis : plant.axes)
        highest = std::max(highest, axis.order);
    auto const own = std::min(order + 1, highest);
    auto const least = std::min(1u, highest);
    AxisId best = 0;
    double min_cost = std::numeric_limits<double>::infinity();
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        if (axis.order < least || rest.axis_length_mm[id] <= 0)
            continue;
        double const cost = std::abs(std::log(length_mm / rest.axis_length_mm[id]))
            + kOrderCost * std::abs(static_cast<double>(axis.order) - static_cast<double>(own));
        if (cost < min_cost) {
            min_cost = cost;
            best = id;
        }
    }
    return best;
}

double share_on_axis(Axis const& axis, AxisId id, RestShape const& rest, SegmentId segment,
                     double part)
{
    double const length_mm = rest.axis_length_mm[id];
    if (length_mm <= 0)
        return (segment - axis.first_segment + part) / axis.segment_count;
    return std::clamp((rest.end_mm[segment] - (1 - part) * rest.length_mm[segment]) / length_mm,
                      0.0, 1.0);
}

std::vector<LimbNode> limb_nodes(Plant const& plant, RestShape const& rest, AxisId pattern,
                                 double length_ratio)
{
    auto const& axis = plant.axes[pattern];
    auto const nodes = BearingNodes(plant, rest, pattern).list();
    if (nodes.empty())
        return {};
    auto const last = static_cast<double>(nodes.size() - 1);
    // Number of intervals between the limb's nodes with twigs or organs.
    double const wanted = std::round(std::min(last * length_ratio, kMaxNodes));
    auto const count = static_cast<std::size_t>(std::max(wanted, last > 0 ? 1.0 : 0.0));
    std::vector<LimbNode> result;
    for (std::size_t k = 0; k <= count; ++k) {
        double const place
            = count > 0 ? last * static_cast<double>(k) / static_cast<double>(count) : 0;
        auto const below = std::min(static_cast<std::size_t>(place), nodes.size() - 1);
        auto const above = std::min(below + 1, nodes.size() - 1);
        double const part = place - static_cast<double>(below);
        auto const share = [&](std::size_t i) {
            return share_on_axis(axis, pattern, rest, nodes[i].segment, 1);
        };
        auto const nearest = part < 0.5 ? below : above;
        result.push_back(
            { share(below) + part * (share(above) - share(below)), nodes[nearest].segment,
              nearest == k ? 0 : continued_angle_rad(nodes, k) - nodes[nearest].angle_rad });
    }
    return result;
}

std::vector<LimbStation> limb_stations(std::vector<LimbNode> const& nodes, double drawn_from)
{
    std::vector<LimbStation> wanted { { 0 } };
    auto const add = [&](double share) -> LimbStation& {
        if (share <= wanted.back().share)
            return wanted.back();
        double const from = wanted.back().share;
        auto const pieces = std::max(1.0, std::ceil((share - from) * kMinLimbSegments - 1e-9));
        for (double i = 1; i < pieces; ++i)
            wanted.push_back({ from + (share - from) * i / pieces });
        return wanted.emplace_back(LimbStation { share });
    };
    bool is_joined = drawn_from <= 0;
    for (auto const& node : nodes) {
        if (!is_joined && node.share >= drawn_from) {
            add(drawn_from);
            is_joined = true;
        }
        add(node.share).bears.push_back(node);
    }
    if (!is_joined)
        add(drawn_from);
    add(1);
    // Twigs and organs at the limb's base move to the end of its first segment.
    if (wanted.size() > 1 && !wanted.front().bears.empty()) {
        auto& second = wanted[1].bears;
        second.insert(second.begin(), wanted[0].bears.begin(), wanted[0].bears.end());
    }
    return wanted;
}

} // namespace tractus::variation
