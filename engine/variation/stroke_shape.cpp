#include "engine/variation/stroke_shape.h"

#include "engine/stroke/frame_rotation.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/smooth.h"

#include <fmt/format.h>

namespace tractus::variation {

namespace {

// The chord of this share of a stroke, from its start, is taken as the tangent there.
constexpr double kStartShare = 0.05;

// A chord shorter than this share of the stroke's length gives no direction.
constexpr double kNoChord = 1e-6;

Result<void> check_path(Plant const& plant, std::span<SegmentId const> path)
{
    if (path.empty())
        return fail(Fault::User, "no branch is selected for the stroke: select one first");
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (path[i] >= plant.segment_count())
            return fail(Fault::User,
                        fmt::format("segment {} is not in the plant, which has {}: select "
                                    "the branch again",
                                    path[i], plant.segment_count()));
        if (i > 0 && parent_segment(plant, path[i]) != path[i - 1])
            return fail(Fault::User,
                        fmt::format("segment {} does not stand on segment {}, so the "
                                    "selected path is broken: select it again",
                                    path[i], path[i - 1]));
    }
    return {};
}

Vec3 start_tangent(ArcLength const& curve)
{
    for (double share = kStartShare; share < 1; share *= 2) {
        Vec3 const chord = curve.at(share) - curve.at(0);
        // If the chord is shorter, the stroke turns back on itself, and a longer share is tried.
        if (chord.norm() > 0.01 * share * curve.length_mm())
            return chord.normalized();
    }
    Vec3 const chord = curve.at(0.5) - curve.at(0);
    return chord.isZero(0) ? Vec3(Vec3::UnitZ()) : Vec3(chord.normalized());
}

Vec3 chord_of(ArcLength const& curve)
{
    return curve.at(1) - curve.at(0);
}

// Returns the direction from the base of the first segment to the tip of the last, or `otherwise`
// if they coincide.
Vec3 chord_direction(Plant const& plant, SegmentId first, SegmentId last, Vec3 const& otherwise)
{
    Vec3 const chord = plant.node_position_mm[nodes_of(plant, last).tip]
        - plant.node_position_mm[nodes_of(plant, first).base];
    double const length = chord.norm();
    return length > 0 ? Vec3(chord / length) : otherwise;
}

// Returns the direction of the curve that is aligned with a branch.
Vec3 direction_of(ArcLength const& curve, StrokeFit fit)
{
    return fit == StrokeFit::Chord ? Vec3(chord_of(curve).normalized()) : start_tangent(curve);
}

Result<ArcLength> curve_of(Stroke const& stroke, StrokeFit fit, double detail_weight)
{
    if (!(detail_weight >= 0 && detail_weight <= 1))
        return fail(
            Fault::User,
            fmt::format("{} of the hand cannot be kept: give a share from 0 to 1", detail_weight));
    auto const tips = TRY(stroke.tips.in_memory());
    auto const points = TRY(stroke_points({ tips }));
    ArcLength curve(smooth_hand_line(points, detail_weight));
    if (fit == StrokeFit::Chord && chord_of(curve).norm() <= kNoChord * curve.length_mm())
        return fail(Fault::User,
                    "the stroke ends where it began, so it has no chord to lay along the "
                    "branch's: fit it by its start");
    return curve;
}

// Returns, for each segment of the path, the direction of its piece of the curve, rotated by
// `to_base`. Empty if the path has no length.
std::vector<Vec3> directions_along(std::span<SegmentId const> path, RestShape const& rest,
                                   ArcLength const& curve, Quat const& to_base)
{
    double total_mm = 0;
    for (auto const segment : path)
        total_mm += rest.length_mm[segment];
    std::vector<Vec3> directions;
    if (!(total_mm > 0))
        return directions;
    double sum_mm = 0;
    Vec3 from = curve.at(0);
    Vec3 before = tangent_of(rest.frame[path.front()]);
    for (auto const segment : path) {
        sum_mm += rest.length_mm[segment];
        Vec3 const to = curve.at(sum_mm / total_mm);
        // A chord without length, where the stroke turns back on itself, keeps the previous
        // direction.
        Vec3 const chord = to_base * (to - from);
        if (double const length = chord.norm(); length > 0)
            before = chord / length;
        directions.push_back(before);
        from = to;
    }
    return directions;
}

std::vector<Joint> joints_along(std::span<SegmentId const> path, RestShape const& rest,
                                StrokeShape const& stroke, ArcLength const& curve)
{
    auto const directions = directions_along(path, rest, curve, stroke.to_path);
    std::vector<Joint> joints(path.size());
    Vec3 base_before = tangent_of(rest.frame[path.front()]);
    Vec3 bent_before = base_before;
    // Rotation of the preceding segment of the path, from the base plant to the bent one.
    Quat turn_before = Quat::Identity();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        if (stroke.fit == StrokeFit::World) {
            joints[i] = { .kind = Joint::Kind::World, .direction = directions[i] };
            continue;
        }
        // Both the base plant and the stroke are followed without twist. The difference is the
        // rotation of the segment.
        Vec3 const base = tangent_of(rest.frame[path[i]]);
        Quat const turn = (least_rotation(bent_before, directions[i]) * turn_before
                           * least_rotation(base_before, base).conjugate())
                              .normalized();
        joints[i] = { .kind = Joint::Kind::Turn, .turn = turn_before.conjugate() * turn };
        base_before = base;
        bent_before = directions[i];
        turn_before = turn;
    }
    return joints;
}

// Fills in the joints of the path, for a stroke that is aligned by heading and pitch.
void show_along_path(std::span<SegmentId const> path, RestShape const& rest, ArcLength const& curve,
                     StrokeShape& stroke)
{
    std::vector<double> lengths_mm;
    std::vector<Quat> frames;
    for (auto const segment : path) {
        lengths_mm.push_back(rest.length_mm[segment]);
        frames.push_back(rest.frame[segment]);
    }
    double const share = start_share(lengths_mm, stroke.first_turn);
    auto const shown = sample_stroke(curve, lengths_mm, stroke.fit, share);
    stroke.path_aim = aim_of_stroke(shown.direction, stroke.reach);
    stroke.path_direction = branch_direction(frames, lengths_mm, stroke.fit, share);
    for (std::size_t i = 0; i < path.size(); ++i)
        stroke.joints.push_back({ .kind = Joint::Kind::Laid,
                                  .direction = shown.directions[i],
                                  .in_path = static_cast<std::uint32_t>(i) });
}

// Returns the least rotation of the direction `from` of a curve to the direction `to` in the base
// plant; the identity for StrokeFit::World.
Quat laid(StrokeFit fit, Vec3 const& from, Vec3 const& to)
{
    return fit == StrokeFit::World ? Quat::Identity() : least_rotation(from, to);
}

// Fills in the rotations and joints of a stroke with StrokeLaying::LeastTwist or StrokeFit::World.
void follow_path(Plant const& plant, RestShape const& rest, Association const& association,
                 ArcLength const& curve, StrokeShape& stroke)
{
    auto const& path = association.path;
    Quat const& base = rest.frame[path.front()];
    Vec3 to = tangent_of(base);
    if (stroke.fit == StrokeFit::Chord)
        to = chord_direction(plant, path.front(), path.back(), to);
    stroke.to_path = laid(stroke.fit, direction_of(curve, stroke.fit), to);
    stroke.from_path = base.conjugate() * stroke.to_path;
    if (association.propagation != Propagation::Descendants)
        stroke.joints = joints_along(path, rest, stroke, curve);
}

} // namespace

Result<void> check_shaping_stroke(ShapingStroke const& stroke)
{
    TRY(curve_of(stroke.stroke, stroke.fit, stroke.detail_weight));
    return {};
}

Result<void> check_association(Plant const& plant, Association const& association)
{
    if (association.is_orphaned)
        return {};
    TRY(check_path(plant, association.path));
    TRY(curve_of(association.stroke, association.fit, association.detail_weight));
    return {};
}

Result<StrokeShape> shape_of(Plant const& plant, RestShape const& rest,
                             Association const& association)
{
    StrokeShape stroke;
    stroke.fit = association.fit;
    if (association.is_orphaned)
        return stroke;
    auto const& path = association.path;
    TRY(check_path(plant, path));
    auto curve = TRY(curve_of(association.stroke, association.fit, association.detail_weight));

    stroke.is_laid_by_heading = association.laying == StrokeLaying::HeadingAndPitch
        && association.fit != StrokeFit::World;
    if (stroke.is_laid_by_heading) {
        stroke.reach = farthest_reach(curve.points());
        if (stroke.fit == StrokeFit::Start)
            stroke.first_turn = first_turn_share(curve);
        if (association.propagation != Propagation::Descendants)
            show_along_path(path, rest, curve, stroke);
    } else {
        follow_path(plant, rest, association, curve, stroke);
    }
    if (association.propagation != Propagation::Selected)
        stroke.curve = std::make_shared<ArcLength const>(std::move(curve));
    return stroke;
}

Quat curve_to_axis(Plant const& plant, RestShape const& rest, StrokeShape const& stroke, AxisId id)
{
    if (stroke.fit == StrokeFit::World)
        return Quat::Identity();
    auto const& axis = plant.axes[id];
    Quat const along_start = rest.frame[axis.first_segment] * stroke.from_path;
    if (stroke.fit == StrokeFit::Start)
        return along_start;
    // StrokeFit::Chord: the curve is aligned by its start, as on the path, then rotated so that its
    // chord agrees with that of the axis.
    auto const nodes = plant.positions(axis);
    Vec3 const chord = nodes.back() - nodes.front();
    double const length = chord.norm();
    if (!(length > 0))
        return along_start;
    Vec3 const drawn = along_start * chord_of(*stroke.curve).normalized();
    return least_rotation(drawn, chord / length) * along_start;
}

} // namespace tractus::variation
