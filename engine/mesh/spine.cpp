#include "engine/mesh/spine.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tractus::mesh {
namespace {

// Minimum radius of a tube. With radius 0 its sections would have no direction.
constexpr double kMinRadius_mm = 1e-3;
// A tip with a radius of up to this share of that at the axis' base is meshed as a point.
constexpr double kPointedShare = 0.02;
constexpr double kTurnPerPiece_rad = 0.1;  // Maximum turn per piece of a rounded bend.
constexpr double kElbowStep_rad = 0.5;     // Maximum turn between two sections of an elbow.
constexpr double kRoundable_cosine = 0.26; // Cosine of 75 degrees. Sharper bends become elbows.
// Cosine of 0.5 radians. Without rounding, sharper bends become elbows.
constexpr double kStraight_cosine = 0.878;

// The segment to which an axis is attached.
struct Parent {
    double radius_mm;
    Vec3 direction;
    bool continued; // True if the lateral axis continues this one from its end (sympodial fork).
};

void collect_nodes(Plant const& plant, Axis const& axis, std::vector<SpineBuffers::Node>& nodes)
{
    nodes.clear();
    auto const positions = plant.positions(axis);
    auto const* const radii = plant.node_radius_mm.data() + axis.first_node;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        double const radius = std::max<double>(radii[i], kMinRadius_mm);
        SegmentId const segment = axis.first_segment + (i == 0 ? 0 : i - 1);
        if (nodes.empty()) {
            nodes.push_back({ positions[i], Vec3::UnitZ(), 0, radius, segment });
            continue;
        }
        auto& last = nodes.back();
        Vec3 const step = positions[i] - last.position_mm;
        double const length = step.norm();
        if (length < kSameNode_mm) {
            last.radius_mm = std::max(last.radius_mm, radius);
            continue;
        }
        last.direction = step / length;
        last.length_mm = length;
        nodes.push_back({ positions[i], last.direction, 0, radius, segment });
    }
}

int sides_for(std::vector<SpineBuffers::Node> const& nodes, MeshOptions const& options,
              double thickest_mm)
{
    double radius = 0;
    for (auto const& node : nodes)
        radius = std::max(radius, node.radius_mm);
    double const share = std::sqrt(std::min(1.0, radius / std::max(thickest_mm, kMinRadius_mm)));
    return std::clamp(static_cast<int>(std::lround(share * options.max_sides)),
                      std::min(options.min_sides, options.max_sides), options.max_sides);
}

// Returns the circumradius of a regular polygon that has the area of the unit circle.
double same_area_radius(int sides)
{
    return std::sqrt(2 * kPi / (sides * std::sin(2 * kPi / sides)));
}

// Returns the segment to which an axis is attached. No value if the axis is on the ground, or its
// base lies outside the parent's wood.
std::optional<Parent> find_parent(Plant const& plant, Axis const& axis)
{
    if (axis.parent_axis == kNone)
        return std::nullopt;
    auto const& parent_axis = plant.axes[axis.parent_axis];
    auto const segment = axis.parent_segment - parent_axis.first_segment;
    NodeId const end = parent_axis.first_node + segment + 1;
    double const radius = std::max<double>(plant.node_radius_mm[end], kMinRadius_mm);
    Vec3 const& position = plant.node_position_mm[end];
    if ((plant.node_position_mm[axis.first_node] - position).norm() > radius + kSameNode_mm)
        return std::nullopt;
    Vec3 const step = position - plant.node_position_mm[end - 1];
    double const length = step.norm();
    bool const continued = segment + 1 == parent_axis.segment_count
        && plant.node_radius_mm[axis.first_node] >= 0.6 * radius;
    return Parent { radius, length > 0 ? Vec3(step / length) : Vec3::UnitZ(), continued };
}

class Tracer {
public:
    Tracer(MeshOptions const& options, SpineBuffers& room)
        : rounding_(options.subdivision > 1)
        , pieces_(std::max(1, options.subdivision))
        , nodes_(room.nodes)
        , stations_(room.stations)
    {
    }

    void trace(std::optional<Parent> const& parent)
    {
        stations_.clear();
        Vec3 tangent = base_tangent(parent);
        add({ nodes_[0].position_mm, tangent, nodes_[0].radius_mm, 0, nodes_[0].segment });
        for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
            bool const last = i + 2 == nodes_.size();
            bool const elbow = !last && is_elbow(i + 1);
            Vec3 const end = last || elbow ? nodes_[i].direction : tangent_at(i + 1);
            add_stretch(i, tangent, end);
            tangent = end;
            if (elbow) {
                add_elbow(i + 1);
                tangent = nodes_[i + 1].direction;
            }
        }
    }

private:
    // Returns the tangent at the base of the axis. An axis that continues its parent begins in the
    // parent's direction and then bends into its own, so that the two limbs of a fork separate
    // gradually.
    Vec3 base_tangent(std::optional<Parent> const& parent) const
    {
        Vec3 const& own = nodes_[0].direction;
        bool const follows = parent && parent->continued && rounding_
            && parent->direction.dot(own) >= kRoundable_cosine;
        return follows ? parent->direction : own;
    }

    bool is_elbow(std::size_t node) const
    {
        double const cosine = nodes_[node - 1].direction.dot(nodes_[node].direction);
        return cosine < (rounding_ ? kRoundable_cosine : kStraight_cosine);
    }

    // Returns the tangent at a node between two segments. Without rounding it bisects their
    // directions; with rounding it is closer to the direction of the shorter one, as on a circle
    // through the three nodes.
    Vec3 tangent_at(std::size_t node) const
    {
        auto const& before = nodes_[node - 1];
        auto const& after = nodes_[node];
        if (!rounding_)
            return (before.direction + after.direction).normalized();
        return (after.length_mm * before.direction + before.length_mm * after.direction)
            .normalized();
    }

    void add(SpineStation station)
    {
        if (!stations_.empty())
            station.arc_mm
                = stations_.back().arc_mm + (station.center_mm - stations_.back().center_mm).norm();
        stations_.push_back(station);
    }

    // Adds the stations from node `i` to the next node. They are on a cubic Hermite curve, which is
    // divided into as many pieces as its bend requires, up to pieces_.
    void add_stretch(std::size_t i, Vec3 const& start, Vec3 const& end)
    {
        auto const& from = nodes_[i];
        auto const& to = nodes_[i + 1];
        double const turn = (start - from.direction).norm() + (end - from.direction).norm();
        int const pieces
            = std::clamp(static_cast<int>(std::ceil(turn / kTurnPerPiece_rad)), 1, pieces_);
        for (int k = 1; k < pieces; ++k) {
            double const u = static_cast<double>(k) / pieces;
            double const w = 1 - u;
            Vec3 const center = w * w * (1 + 2 * u) * from.position_mm
                + u * u * (3 - 2 * u) * to.position_mm
                + from.length_mm * u * w * (w * start - u * end);
            Vec3 const derivative
                = 6 * u * w * from.direction + w * (1 - 3 * u) * start + u * (3 * u - 2) * end;
            double const speed = derivative.norm();
            add({ center, speed > 1e-6 ? Vec3(derivative / speed) : from.direction,
                  w * from.radius_mm + u * to.radius_mm, 0, to.segment });
        }
        add({ to.position_mm, end, to.radius_mm, 0, to.segment });
    }

    // Adds sections at a node that turn from the direction before it to the direction after it. On
    // the outside of the bend they form a rounded corner; on the inside they lie within the two
    // tubes.
    void add_elbow(std::size_t node)
    {
        Vec3 const& before = nodes_[node - 1].direction;
        Vec3 const& after = nodes_[node].direction;
        double const angle = std::acos(std::clamp(before.dot(after), -1.0, 1.0));
        Vec3 side = after - before * before.dot(after);
        // The direction is reversed or the same, so any axis of rotation will do.
        if (side.norm() < 1e-6)
            side = before.unitOrthogonal();
        side.normalize();
        int const steps = std::max(1, static_cast<int>(std::ceil(angle / kElbowStep_rad)));
        for (int k = 1; k <= steps; ++k) {
            double const turn = angle * k / steps;
            add({ nodes_[node].position_mm,
                  (std::cos(turn) * before + std::sin(turn) * side).normalized(),
                  nodes_[node].radius_mm, 0, nodes_[node].segment });
        }
    }

    bool rounding_;
    int pieces_;
    std::vector<SpineBuffers::Node> const& nodes_;
    std::vector<SpineStation>& stations_;
};

// Inserts a station at `arc_mm`, unless the spine is shorter than that or another station is within
// `spacing_mm`.
void insert_station(std::vector<SpineStation>& stations, double arc_mm, double spacing_mm)
{
    auto const after = std::lower_bound(
        stations.begin(), stations.end(), arc_mm,
        [](SpineStation const& station, double arc) { return station.arc_mm < arc; });
    if (after == stations.begin() || after == stations.end())
        return;
    auto const before = after - 1;
    if (after->arc_mm - arc_mm < spacing_mm || arc_mm - before->arc_mm < spacing_mm)
        return;
    double const share = (arc_mm - before->arc_mm) / (after->arc_mm - before->arc_mm);
    Vec3 const blend = (1 - share) * before->tangent + share * after->tangent;
    SpineStation const station { (1 - share) * before->center_mm + share * after->center_mm,
                                 blend.norm() > 1e-6 ? Vec3(blend.normalized()) : after->tangent,
                                 (1 - share) * before->radius_mm + share * after->radius_mm, arc_mm,
                                 after->segment };
    stations.insert(after, station);
}

// Radius profile of an axis at its base: constant inside the parent, then falling to the axis' own
// radius. A lateral axis narrows fast at first, like the swelling around a real branch. An axis
// that continues its parent narrows gently at first, so that the two join smoothly.
struct Collar {
    double base_radius_mm; // Radius at the parent's centre line.
    double level_mm;       // Arc length, from the base, over which base_radius_mm is kept.
    double fall_mm; // Arc length, after level_mm, over which the radius falls to the axis' own.
    bool soft;      // True if the fall of the radius not only ends but also begins gently.

    // Returns the share of the swelling that is left at an arc length from the base, from 1 to 0.
    double share(double arc_mm) const
    {
        double const x = std::clamp((arc_mm - level_mm) / fall_mm, 0.0, 1.0);
        return soft ? (1 - x) * (1 - x) * (1 + 2 * x) : (1 - x) * (1 - x);
    }
};

Collar collar_on(Parent const& parent, SpineBuffers const& spine, MeshOptions const& options)
{
    double const radius = spine.nodes[0].radius_mm;
    double const length = spine.stations.back().arc_mm;
    if (parent.continued)
        return { parent.radius_mm, 0, std::min(4 * parent.radius_mm, 0.8 * length), true };
    double const cosine = parent.direction.dot(spine.nodes[0].direction);
    double const sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    double const inside = parent.radius_mm / std::max(0.4, sine);
    return { std::min(0.95 * parent.radius_mm, radius * (1 + options.collar)),
             std::min(inside, 0.5 * length), std::min(4.5 * radius, 0.4 * length), false };
}

// Widens the spine at its base.
void apply_collar(SpineBuffers& spine, Collar const& collar)
{
    auto& stations = spine.stations;
    double const spacing = 0.15 * collar.fall_mm;
    // A saddle begins exactly at this level.
    insert_station(stations, collar.level_mm, 0.01 * collar.fall_mm);
    for (double const share : { 0.2, 0.5, 1.0 })
        insert_station(stations, collar.level_mm + share * collar.fall_mm, spacing);
    double const rise = collar.base_radius_mm - spine.nodes[0].radius_mm;
    for (auto& station : stations) {
        double const share = collar.share(station.arc_mm);
        if (share <= 0)
            break;
        station.radius_mm = std::max(kMinRadius_mm, station.radius_mm + rise * share);
    }
}

// Returns the saddle between an axis with this collar and its parent. None if the axis continues
// its parent, or runs along it.
Saddle saddle_on(Parent const& parent, SpineBuffers const& spine, Collar const& collar)
{
    constexpr double kLeastSine = 0.4;
    auto const& direction = spine.nodes[0].direction;
    double const sine = parent.direction.cross(direction).norm();
    // The collar of a short axis begins inside the parent.
    bool const leaves = collar.level_mm * sine > 0.9 * parent.radius_mm;
    if (parent.continued || sine < kLeastSine || !leaves)
        return {};
    return { .base_mm = spine.nodes[0].position_mm,
             .parent_direction = parent.direction,
             .parent_radius_mm = parent.radius_mm,
             .level_mm = collar.level_mm,
             .end_mm = collar.level_mm + collar.fall_mm };
}

// Returns the ridges of a trunk, and adds the stations that show how they fade. No ridges for axes
// that are much thinner than the plant's thickest one, or do not rise.
Ridges add_ridges(RootFlare const& flare, double thickest_mm, std::vector<SpineStation>& stations)
{
    auto const base = stations.front();
    bool const is_trunk = base.radius_mm >= 0.5 * thickest_mm && base.tangent.z() > 0.5;
    if (flare.ridges == 0 || !(flare.depth > 0) || !is_trunk)
        return {};
    double const reach_mm = 1.2 * base.radius_mm;
    for (double const share : { 0.15, 0.35, 0.6, 1.0, 1.5, 2.2, 3.0 })
        insert_station(stations, share * reach_mm, 0.1 * reach_mm);
    return { flare.ridges, flare.depth, flare.turn, reach_mm };
}

} // namespace

Spine trace_spine(Plant const& plant, Axis const& axis, MeshOptions const& options,
                  double thickest_mm, SpineBuffers& room)
{
    room.stations.clear();
    collect_nodes(plant, axis, room.nodes);
    if (room.nodes.size() < 2)
        return {};
    auto const parent = find_parent(plant, axis);
    Spine spine;
    spine.sides = sides_for(room.nodes, options, thickest_mm);
    spine.closed_base = !parent && options.ends == MeshOptions::Ends::Closed;
    Tracer(options, room).trace(parent);

    bool const thin = spine.sides <= options.min_sides && options.min_sides < options.max_sides;
    if (parent && options.collar > 0 && (!thin || parent->continued)) {
        auto const collar = collar_on(*parent, room, options);
        apply_collar(room, collar);
        spine.saddle = saddle_on(*parent, room, collar);
        if (spine.saddle.parent_radius_mm > 0) {
            spine.overhang_mm = collar.fall_mm;
            // Inside the parent only the base is needed; corners of the saddle may be below other
            // stations.
            std::erase_if(room.stations, [&](SpineStation const& station) {
                return station.arc_mm > 0 && station.arc_mm < collar.level_mm;
            });
        }
    } else if (parent) {
        room.stations.front().radius_mm
            = std::min(room.stations.front().radius_mm, parent->radius_mm);
    } else if (axis.parent_axis == kNone && options.sections == MeshOptions::Sections::OnCircle) {
        spine.ridges = add_ridges(plant.root_flare, thickest_mm, room.stations);
        constexpr int kSidesPerRidge = 5;
        spine.sides = std::clamp(kSidesPerRidge * spine.ridges.count, spine.sides, 64);
        spine.overhang_mm = Ridges::kHighest * spine.ridges.depth * room.stations.front().radius_mm;
    }

    if (options.sections == MeshOptions::Sections::SameArea)
        for (auto& station : room.stations)
            station.radius_mm *= same_area_radius(spine.sides);
    auto& end = room.stations.back();
    spine.tip = options.ends == MeshOptions::Ends::Closed ? Spine::Tip::Dome : Spine::Tip::Open;
    if (end.radius_mm <= std::max(kMinRadius_mm, kPointedShare * room.nodes[0].radius_mm)) {
        spine.tip = Spine::Tip::Point;
        end.radius_mm = 0;
    }
    spine.stations = room.stations;
    return spine;
}

} // namespace tractus::mesh
