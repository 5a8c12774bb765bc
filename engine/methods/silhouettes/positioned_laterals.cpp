#include "engine/methods/silhouettes/positioned_laterals.h"

#include "engine/methods/silhouettes/branch_style.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr double kTangentOver = 0.02;  // Length over which the parent's tangent is taken on both
                                       // sides, as a share of the parent's length.
constexpr double kStraightOn_deg = 20; // A child at the tip within this angle continues its parent.
// Children closer than this share of their mean distance are at one node.
constexpr double kSameNode = 0.2;

// An axis, evaluated by arc length.
class AxisLine {
public:
    explicit AxisLine(std::span<Vec3 const> nodes)
        : nodes_(nodes)
        , to_mm_ { 0 }
    {
        for (std::size_t i = 1; i < nodes.size(); ++i)
            to_mm_.push_back(to_mm_.back() + (nodes[i] - nodes[i - 1]).norm());
    }

    double length_mm() const { return to_mm_.back(); }
    double length_to_mm(std::size_t node) const { return to_mm_[node]; }

    Vec3 at(double length_mm) const
    {
        auto const after = std::upper_bound(to_mm_.begin(), to_mm_.end(), length_mm);
        auto const i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            after - to_mm_.begin() - 1, 0, static_cast<std::ptrdiff_t>(nodes_.size()) - 2));
        double const width = to_mm_[i + 1] - to_mm_[i];
        double const share = width > 0 ? std::clamp((length_mm - to_mm_[i]) / width, 0.0, 1.0) : 0;
        return nodes_[i] + share * (nodes_[i + 1] - nodes_[i]);
    }

    // Tangent at an arc length; zero for an axis without length.
    Vec3 direction(double length_mm) const
    {
        double const step_mm = kTangentOver * this->length_mm();
        return (at(length_mm + step_mm) - at(length_mm - step_mm)).normalized();
    }

private:
    std::span<Vec3 const> nodes_;
    std::vector<double> to_mm_;
};

} // namespace

std::vector<PositionedLateral> children_of(Plant const& plant, AxisId parent,
                                           std::span<AxisId const> ids)
{
    auto const& axis = plant.axes[parent];
    AxisLine const line(plant.positions(axis));
    std::vector<std::pair<double, AxisId>> places;
    for (auto const id : ids) {
        auto const node = plant.axes[id].parent_segment - axis.first_segment + std::size_t { 1 };
        places.emplace_back(line.length_to_mm(std::min<std::size_t>(node, axis.segment_count)), id);
    }
    std::sort(places.begin(), places.end());
    std::vector<PositionedLateral> children;
    Vec3 before = line.direction(0);
    Vec3 across = before.unitOrthogonal();
    for (auto const& [at_mm, id] : places) {
        auto const nodes = plant.positions(plant.axes[id]);
        AxisLine const own(nodes);
        Vec3 const along = line.direction(at_mm);
        Vec3 const way = own.at(kAngleOver * own.length_mm()) - nodes.front();
        if (!(way.norm() > 0 && along.norm() > 0))
            continue;
        across = Quat::FromTwoVectors(before, along) * across;
        before = along;
        Vec3 const out = way.normalized();
        double const u = at_mm / line.length_mm();
        double const angle_deg = degrees(std::acos(std::clamp(along.dot(out), -1.0, 1.0)));
        if (u > 0.999 && angle_deg < kStraightOn_deg)
            continue;
        double const azimuth = std::atan2(along.cross(across).dot(out), across.dot(out));
        children.push_back({ u, angle_deg, degrees(azimuth), own.length_mm() / line.length_mm() });
    }
    return children;
}

std::vector<NodeOfChildren> nodes_of(std::span<PositionedLateral const> children)
{
    std::vector<NodeOfChildren> nodes;
    double const mean_gap = (children.back().u - children.front().u)
        / static_cast<double>(std::max<std::size_t>(children.size() - 1, 1));
    std::size_t first = 0;
    for (std::size_t i = 1; i <= children.size(); ++i) {
        if (i < children.size() && children[i].u - children[first].u <= kSameNode * mean_gap)
            continue;
        nodes.push_back({ children[first].u, children.subspan(first, i - first) });
        first = i;
    }
    return nodes;
}

} // namespace tractus::silhouette
