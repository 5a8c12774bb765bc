#include "engine/variation/stroke_shaper.h"

#include "engine/base/check.h"
#include "engine/stroke/frame_rotation.h"
#include "engine/variation/subtree.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace tractus::variation {

// True if two associations have the same effect.
static bool same(Association const& a, Association const& b)
{
    auto const same_place = [](TipSample const& tip, TipSample const& other) {
        return tip.position_mm == other.position_mm;
    };
    if (a.path != b.path || a.propagation != b.propagation || a.fit != b.fit
        || a.detail_weight != b.detail_weight || a.laying != b.laying || a.spared != b.spared
        || a.is_orphaned != b.is_orphaned)
        return false;
    if (a.stroke.tips.id() == b.stroke.tips.id())
        return true;
    auto const tips = a.stroke.tips.in_memory();
    auto const others = b.stroke.tips.in_memory();
    // Associations whose tips cannot be read count as different, so that they are processed again
    // and the error is reported.
    return tips && others
        && std::equal(tips->begin(), tips->end(), others->begin(), others->end(), same_place);
}

StrokeShaper::StrokeShaper(Plant const& plant, RestShape const& rest)
    : plant_(plant)
    , rest_(rest)
    , shape_ { rest.frame }
    , sources_(plant.axes.size())
{
    CHECK(rest.frame.size() == plant.segment_count());
}

Result<void> StrokeShaper::set(std::span<Association const> associations)
{
    auto const differ = std::mismatch(associations_.begin(), associations_.end(),
                                      associations.begin(), associations.end(), same);
    auto const unchanged = static_cast<std::size_t>(differ.first - associations_.begin());
    auto changed = TRY(shapes_of(associations, unchanged));
    associations_.assign(associations.begin(), associations.end());
    strokes_.resize(unchanged);
    std::move(changed.begin(), changed.end(), std::back_inserter(strokes_));

    auto const before = std::exchange(sources_, std::vector<Source>(plant_.axes.size()));
    joints_.clear();
    for (std::uint32_t number = 0; number < associations_.size(); ++number)
        assign(number);

    auto const dirty = find_dirty(before, unchanged);
    for_each_level(rest_.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes)
            if (dirty[id])
                lay(id);
    });
    return {};
}

// Prepares the strokes of the associations from number `first` on. For associations whose number
// alone has changed, the StrokeShape is kept, so that their tips need not be read again.
Result<std::vector<StrokeShape>> StrokeShaper::shapes_of(std::span<Association const> associations,
                                                         std::size_t first) const
{
    std::unordered_multimap<void const*, std::size_t> before;
    for (auto number = first; number < associations_.size(); ++number)
        before.emplace(associations_[number].stroke.tips.id(), number);
    std::vector<StrokeShape> shapes;
    for (auto const& association : associations.subspan(first)) {
        auto const [begin, end] = before.equal_range(association.stroke.tips.id());
        auto const found = std::find_if(begin, end, [&](auto const& entry) {
            return same(associations_[entry.second], association);
        });
        shapes.push_back(found != end ? strokes_[found->second]
                                      : TRY(shape_of(plant_, rest_, association)));
    }
    return shapes;
}

void StrokeShaper::assign(std::uint32_t number)
{
    auto const& association = associations_[number];
    if (association.is_orphaned)
        return;
    if (association.propagation != Propagation::Descendants)
        assign_path(number);
    if (association.propagation != Propagation::Selected)
        assign_descendants(number);
}

void StrokeShaper::assign_path(std::uint32_t number)
{
    auto const& path = associations_[number].path;
    auto const& joints = strokes_[number].joints;
    AxisId id = axis_of(plant_, path.front());
    for (std::size_t i = 0; i < path.size(); ++i) {
        auto const* axis = &plant_.axes[id];
        if (path[i] - axis->first_segment >= axis->segment_count) {
            id = axis_of(plant_, path[i]);
            axis = &plant_.axes[id];
        }
        auto& source = sources_[id];
        if (source.joints == kNone) {
            source.joints = static_cast<std::uint32_t>(joints_.size());
            joints_.emplace_back(axis->segment_count);
        }
        source.changed = number + 1;
        auto& joint = joints_[source.joints][path[i] - axis->first_segment];
        joint = joints[i];
        joint.stroke = number;
    }
}

// Assigns an association to the axes that descend from its path, except those that contain a part
// of the path and those in Association::spared.
void StrokeShaper::assign_descendants(std::uint32_t number)
{
    auto const& path = associations_[number].path;
    auto const& spared = associations_[number].spared;
    std::vector<AxisId> along;
    for (auto const segment : path)
        if (auto const id = axis_of(plant_, segment); along.empty() || along.back() != id)
            along.push_back(id);
    for (auto const& [id, first] : subtree_of(plant_, path.front()))
        // `along` is in ascending order, since a plant lists parents before children.
        if (!std::binary_search(along.begin(), along.end(), id)
            && !std::binary_search(spared.begin(), spared.end(), id))
            sources_[id] = { .propagated = number, .joints = kNone, .changed = number + 1 };
}

// Marks the axes that the associations from number `unchanged` on shape now or shaped before the
// change, and all descendants of these axes.
std::vector<bool> StrokeShaper::find_dirty(std::span<Source const> before,
                                           std::size_t unchanged) const
{
    std::vector<bool> dirty(plant_.axes.size());
    for (AxisId id = 0; id < plant_.axes.size(); ++id) {
        auto const parent = plant_.axes[id].parent_axis;
        dirty[id] = before[id].changed > unchanged || sources_[id].changed > unchanged
            || (parent != kNone && dirty[parent]);
    }
    return dirty;
}

// Returns the rotation of a segment from the base plant to the bent one; the identity for kNone.
Quat StrokeShaper::turn_of_segment(SegmentId segment) const
{
    if (segment == kNone)
        return Quat::Identity();
    auto const& bent = shape_.frame[segment];
    auto const& rest = rest_.frame[segment];
    // The identity is exact if the segment is not bent, so that earlier strokes leave no rounding
    // errors.
    return bent.coeffs() == rest.coeffs() ? Quat::Identity() : bent * rest.conjugate();
}

void StrokeShaper::lay(AxisId id)
{
    auto const& axis = plant_.axes[id];
    auto const& source = sources_[id];
    Quat const turn = turn_of_segment(axis.parent_segment);
    auto const frames = std::span(shape_.frame).subspan(axis.first_segment, axis.segment_count);
    if (source.joints != kNone)
        return lay_joints(id, turn);
    if (source.propagated != kNoStroke)
        return lay_propagated(id, strokes_[source.propagated], turn, frames);
    auto const* const rest = &rest_.frame[axis.first_segment];
    bool const is_turned = turn.coeffs() != Quat::Identity().coeffs();
    for (std::size_t i = 0; i < frames.size(); ++i)
        frames[i] = is_turned ? renormalised(turn * rest[i]) : rest[i];
}

// Returns the heading of a segment in the bent plant. The heading of an upright segment is that of
// its axis' parent segment, and so on downwards; on the ground it is `otherwise`.
Vec2 StrokeShaper::heading_from(SegmentId segment, Vec2 const& otherwise) const
{
    if (segment == kNone)
        return otherwise;
    Vec3 const direction = tangent_of(shape_.frame[segment]);
    auto const below = plant_.axes[axis_of(plant_, segment)].parent_segment;
    return branch_heading(direction, heading_from(below, otherwise));
}

// True if segment `in_path` of the stroke's path is shaped by this stroke and not by a later one.
bool StrokeShaper::is_laid(std::uint32_t stroke, std::size_t in_path) const
{
    auto const segment = associations_[stroke].path[in_path];
    auto const id = axis_of(plant_, segment);
    if (sources_[id].joints == kNone) // A later stroke was propagated to the whole axis.
        return false;
    auto const& joint = joints_[sources_[id].joints][segment - plant_.axes[id].first_segment];
    return joint.kind == Joint::Kind::Laid && joint.stroke == stroke && joint.in_path == in_path;
}

// Returns the rotation of a stroke along its path from segment `in_path` on. It takes into account
// that the parent rotates the path's base. If a later stroke shapes the segments below `in_path`,
// the remaining ones keep their direction relative to those.
Quat StrokeShaper::laid_along_path(std::uint32_t number, std::size_t in_path) const
{
    auto const& path = associations_[number].path;
    auto const& stroke = strokes_[number];
    auto const below = parent_segment(plant_, path.front());
    auto const& axis = plant_.axes[axis_of(plant_, path.front())];
    Quat laid = Quat::Identity();
    if (axis.parent_segment != kNone) {
        Vec3 const direction = (turn_of_segment(below) * stroke.path_direction).normalized();
        auto const heading
            = branch_heading(direction, heading_from(below, stroke.path_aim.heading));
        laid = lay_by_heading(stroke.path_aim, { direction, heading });
    }
    while (in_path > 0 && is_laid(number, in_path - 1))
        --in_path;
    if (in_path == 0)
        return laid;
    Vec3 const as_drawn = (laid * stroke.joints[in_path - 1].direction).normalized();
    return least_rotation(as_drawn, tangent_of(shape_.frame[path[in_path - 1]])) * laid;
}

// Bends a whole axis along a stroke that is aligned by heading and pitch. `turn`: rotation of the
// axis' base by the bending of its parent.
void StrokeShaper::lay_by_heading_along(AxisId id, StrokeShape const& stroke, Quat const& turn,
                                        std::span<Quat> frames) const
{
    auto const& axis = plant_.axes[id];
    auto const lengths_mm
        = std::span(rest_.length_mm).subspan(axis.first_segment, axis.segment_count);
    auto const rest = std::span(rest_.frame).subspan(axis.first_segment, axis.segment_count);
    double const share = start_share(lengths_mm, stroke.first_turn);
    auto const shown = sample_stroke(*stroke.curve, lengths_mm, stroke.fit, share);
    Vec3 const direction
        = (turn * branch_direction(rest, lengths_mm, stroke.fit, share)).normalized();
    Vec2 below = Vec2::UnitX(); // Heading of the parent; needed only for axes near the vertical.
    if (is_upright(direction))
        below = heading_from(axis.parent_segment, reach_heading(rest, lengths_mm, turn));
    auto const laid = lay_by_heading(aim_of_stroke(shown.direction, stroke.reach),
                                     { direction, branch_heading(direction, below) });
    Quat frame = renormalised(turn * rest.front());
    Vec3 before = tangent_of(frame);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Vec3 const to = (laid * shown.directions[i]).normalized();
        frame = parallel_transport(frame, before, to);
        before = to;
        frames[i] = frame;
    }
}

// Bends a whole axis along a stroke. `turn`: rotation of the axis' base by the bending of its
// parent.
void StrokeShaper::lay_propagated(AxisId id, StrokeShape const& stroke, Quat const& turn,
                                  std::span<Quat> frames) const
{
    if (stroke.is_laid_by_heading)
        return lay_by_heading_along(id, stroke, turn, frames);
    auto const& axis = plant_.axes[id];
    auto const* const length_mm = &rest_.length_mm[axis.first_segment];
    bool const is_world = stroke.fit == StrokeFit::World;
    Quat const to_axis
        = is_world ? Quat::Identity() : Quat(turn * curve_to_axis(plant_, rest_, stroke, id));
    Eigen::Matrix3d const rotation = to_axis.toRotationMatrix();
    double const per_mm = rest_.axis_length_mm[id] > 0 ? 1 / rest_.axis_length_mm[id] : 0;

    Quat frame = renormalised(turn * rest_.frame[axis.first_segment]);
    Vec3 before = tangent_of(frame);
    auto const& curve = *stroke.curve;
    Vec3 from = curve.at(0);
    double sum_mm = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        sum_mm += length_mm[i];
        Vec3 const to = curve.at(sum_mm * per_mm);
        Vec3 const chord = rotation * (to - from);
        // A chord without length, where the stroke turns back on itself, keeps the previous
        // direction.
        if (double const length = chord.norm(); length > 0) {
            Vec3 const direction = chord / length;
            frame = parallel_transport(frame, before, direction);
            before = direction;
        }
        frames[i] = frame;
        from = to;
    }
}

// Returns the rotation, relative to the base plant, that gives `segment` the direction `direction`
// without twist. `below`: the segment before it on the path, which was rotated by `turned`; kNone
// for the first segment of a path.
Quat StrokeShaper::follow_joint(SegmentId segment, SegmentId below, Vec3 const& direction,
                                Quat const& turned) const
{
    Vec3 const base = tangent_of(rest_.frame[segment]);
    Vec3 const base_before = below == kNone ? base : tangent_of(rest_.frame[below]);
    return least_rotation((turned * base_before).normalized(), direction) * turned
        * least_rotation(base_before, base).conjugate();
}

// Computes the frames of an axis segment by segment, if paths of associations run along the axis.
void StrokeShaper::lay_joints(AxisId id, Quat const& turn)
{
    auto const& axis = plant_.axes[id];
    auto const& source = sources_[id];
    auto const& joints = joints_[source.joints];
    // Frames of the axis as a propagated stroke shapes them; without one, those of the base plant.
    // The parent counts as unrotated, unless the stroke is aligned by heading.
    std::vector<Quat> own(rest_.frame.begin() + axis.first_segment,
                          rest_.frame.begin() + axis.first_segment + axis.segment_count);
    bool const is_propagated = source.propagated != kNoStroke;
    bool const is_world = is_propagated && strokes_[source.propagated].fit == StrokeFit::World;
    bool const is_by_heading = is_propagated && strokes_[source.propagated].is_laid_by_heading;
    Quat own_before = is_by_heading ? turn : Quat(Quat::Identity());
    if (is_propagated)
        lay_propagated(id, strokes_[source.propagated], own_before, own);

    Quat turned = turn; // Rotation of the preceding segment, from the base plant to the bent one.
    Quat laid = Quat::Identity();
    for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
        Quat const& rest = rest_.frame[axis.first_segment + i];
        Quat const own_turn = own[i] * rest.conjugate();
        auto const& joint = joints[i];
        Vec3 const rides = tangent_of(turned * rest);
        if (joint.kind == Joint::Kind::World)
            turned = least_rotation(rides, joint.direction) * turned;
        else if (joint.kind == Joint::Kind::Turn)
            turned = turned * joint.turn;
        else if (joint.kind == Joint::Kind::Laid) {
            bool const goes_on = i > 0 && joint.in_path > 0 && joints[i - 1].stroke == joint.stroke
                && joints[i - 1].kind == Joint::Kind::Laid;
            if (!goes_on)
                laid = laid_along_path(joint.stroke, joint.in_path);
            auto const segment = axis.first_segment + i;
            auto const below = joint.in_path > 0 ? parent_segment(plant_, segment) : kNone;
            turned = follow_joint(segment, below, (laid * joint.direction).normalized(), turned);
        } else if (is_world)
            turned = least_rotation(rides, tangent_of(own[i])) * turned;
        else
            turned = turned * own_before.conjugate() * own_turn;
        turned.normalize();
        own_before = own_turn;
        shape_.frame[axis.first_segment + i] = renormalised(turned * rest);
    }
}

} // namespace tractus::variation
