#include "engine/variation/limb_twigs.h"

#include "engine/stroke/frame_rotation.h"
#include "engine/variation/stroke_laying.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace tractus::variation {

// Share of a twig's length, from its base, over which the twig's direction is measured.
static constexpr double kTwigStart = 1.0 / 3;

Vec3 LimbTwigs::Move::place(Vec3 const& point_mm) const
{
    return to_mm + scale * (turn * (point_mm - from_mm));
}

LimbTwigs::LimbTwigs(Plant const& plant, RestShape const& rest, AxisId pattern, double scale)
    : plant_(plant)
    , rest_(rest)
    , pattern_(pattern)
    , scale_(scale)
{
    // For each axis, the segment of the pattern from which it descends; kNone if there is none.
    std::vector<SegmentId> root(plant.axes.size(), kNone);
    auto const root_of = [&](SegmentId segment) {
        if (segment == kNone)
            return kNone;
        auto const axis = axis_of(plant, segment);
        return axis == pattern ? segment : root[axis];
    };
    for (AxisId id = pattern + 1; id < plant.axes.size(); ++id) {
        root[id] = root_of(plant.axes[id].parent_segment);
        if (root[id] != kNone)
            borne_[root[id]].axes.push_back(id);
    }
    for (std::size_t i = 0; i < plant.organs.size(); ++i)
        if (auto const segment = root_of(plant.organs[i].segment); segment != kNone)
            borne_[segment].organs.push_back(i);
    for (std::size_t i = 0; i < plant.polygons.size(); ++i)
        if (auto const segment = root_of(plant.polygons[i].segment); segment != kNone)
            borne_[segment].polygons.push_back(i);
}

void LimbTwigs::add(Plant& limb, Place const& place, LimbNode const& node)
{
    Quat const turn(Eigen::AngleAxisd(node.turn_rad, Vec3::UnitX()));
    Move const rigid { plant_.node_position_mm[nodes_of(plant_, node.pattern).tip],
                       limb.node_position_mm[place.segment + 1],
                       place.frame * turn * rest_.frame[node.pattern].conjugate(), scale_ };
    auto const& borne = borne_[node.pattern];
    segments_.clear();
    axes_.clear();
    segments_[node.pattern] = place.segment;
    axes_[pattern_] = { 0, rigid };
    for (auto const id : borne.axes) {
        auto const parent = plant_.axes[id].parent_axis;
        add_twig(limb, id,
                 parent == pattern_ ? upright_move(rigid, start_of_twig(id), node.pattern)
                                    : axes_.at(parent).move);
    }
    for (auto const number : borne.organs) {
        auto const& organ = plant_.organs[number];
        auto const at_node = upright_move(rigid, organ.orientation * Vec3::UnitY(), node.pattern);
        add_organ(limb, organ, move_of(organ.segment, at_node));
    }
    for (auto const number : borne.polygons) {
        auto const& polygon = plant_.polygons[number];
        add_polygon(limb, polygon, move_of(polygon.segment, rigid));
    }
}

// Returns a move like `rigid`, except that it rotates only about the vertical. It turns a twig or
// organ with the direction `direction` to the heading that `rigid` would give it.
LimbTwigs::Move LimbTwigs::upright_move(Move const& rigid, Vec3 const& direction,
                                        SegmentId node) const
{
    Vec3 const along = tangent_of(rest_.frame[node]);
    auto const heading = [](Vec3 const& of, Vec3 const& bearer) {
        return branch_heading(of, branch_heading(bearer, Vec2::UnitX()));
    };
    Vec2 const from = heading(direction, along);
    Vec2 const to = heading((rigid.turn * direction).normalized(), rigid.turn * along);
    double const angle_rad = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
    auto move = rigid;
    move.turn = Quat(Eigen::AngleAxisd(angle_rad, Vec3::UnitZ()));
    return move;
}

Vec3 LimbTwigs::start_of_twig(AxisId id) const
{
    auto const& axis = plant_.axes[id];
    return branch_direction(
        std::span(rest_.frame).subspan(axis.first_segment, axis.segment_count),
        std::span(rest_.length_mm).subspan(axis.first_segment, axis.segment_count),
        StrokeFit::Start, kTwigStart);
}

LimbTwigs::Move const& LimbTwigs::move_of(SegmentId segment, Move const& at_node) const
{
    auto const axis = axis_of(plant_, segment);
    return axis == pattern_ ? at_node : axes_.at(axis).move;
}

// Copies a twig to the limb. The twig's parent must have been copied before; parents come first in
// NodeAttachments::axes.
void LimbTwigs::add_twig(Plant& limb, AxisId id, Move const& move)
{
    auto const& twig = plant_.axes[id];
    Axis axis = twig;
    axis.parent_segment = segments_.at(twig.parent_segment);
    axis.parent_axis = axes_.at(twig.parent_axis).axis;
    auto const& bearer = limb.axes[axis.parent_axis];
    axis.order = bearer.order + 1;
    axis.first_node = static_cast<NodeId>(limb.node_position_mm.size());
    axis.first_segment = static_cast<SegmentId>(limb.segment_material.size());
    auto const seat = bearer.first_node + (axis.parent_segment - bearer.first_segment) + 1;
    auto const most_mm = limb.node_radius_mm[seat];
    for (std::uint32_t i = 0; i <= twig.segment_count; ++i) {
        auto const node = twig.first_node + i;
        limb.node_position_mm.push_back(move.place(plant_.node_position_mm[node]));
        limb.node_radius_mm.push_back(
            std::min(static_cast<float>(scale_) * plant_.node_radius_mm[node], most_mm));
        add_turned_section(limb, plant_, node, move.turn);
    }
    for (std::uint32_t i = 0; i < twig.segment_count; ++i) {
        segments_[twig.first_segment + i] = axis.first_segment + i;
        limb.segment_material.push_back(plant_.segment_material[twig.first_segment + i]);
    }
    axes_[id] = { static_cast<AxisId>(limb.axes.size()), move };
    limb.axes.push_back(axis);
}

void LimbTwigs::add_organ(Plant& limb, Organ organ, Move const& move) const
{
    organ.position_mm = move.place(organ.position_mm);
    organ.orientation = (move.turn * organ.orientation).normalized();
    organ.scale *= static_cast<float>(std::min(1.0, scale_));
    organ.segment = segments_.at(organ.segment);
    limb.organs.push_back(organ);
}

void LimbTwigs::add_polygon(Plant& limb, Polygon polygon, Move const& move) const
{
    auto const first = polygon.first_vertex;
    polygon.first_vertex = static_cast<std::uint32_t>(limb.polygon_vertices_mm.size());
    for (std::uint32_t i = 0; i < polygon.vertex_count; ++i)
        limb.polygon_vertices_mm.push_back(move.place(plant_.polygon_vertices_mm[first + i]));
    polygon.segment = segments_.at(polygon.segment);
    limb.polygons.push_back(polygon);
}

void add_turned_section(Plant& limb, Plant const& plant, NodeId node, Quat const& turn)
{
    if (plant.node_section.empty())
        return;
    auto section = plant.node_section[node];
    section.normal = turn.cast<float>() * section.normal;
    limb.node_section.push_back(section);
}

} // namespace tractus::variation
