#include "engine/variation/association.h"

#include "engine/base/parallel.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"
#include "engine/stroke/smooth.h"
#include "engine/variation/axis_levels.h"

#include <fmt/format.h>
#include <utility>

namespace tractus {

namespace {

// Share of a stroke whose chord is its start tangent.
constexpr double kStartShare = 0.05;

// Sine of the angle below which a branch counts as going straight on from its bearer, so that the
// bearer's direction says nothing about sides.
constexpr double kStraightOn = 0.05;

Vec3 first_normal(Vec3 const& direction, Frame const* bearer)
{
    if (!bearer)
        return normal_towards(direction, Vec3::UnitX());
    bool const straight_on = direction.cross(bearer->tangent).norm() < kStraightOn;
    return normal_towards(direction, straight_on ? bearer->normal : bearer->tangent);
}

struct BaseShape {
    std::vector<Frame> frame; // Per segment, as the next one.
    std::vector<double> length_mm;
};

BaseShape base_shape(Plant const& plant, AxisLevels const& levels)
{
    BaseShape shape;
    shape.frame.resize(plant.segment_count());
    shape.length_mm.resize(plant.segment_count());
    for_each_level(levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes) {
            auto const& axis = plant.axes[id];
            auto const nodes = plant.positions(axis);
            auto const along = rotation_minimising_frames(nodes);
            auto const* const bearer
                = axis.parent_segment == kNone ? nullptr : &shape.frame[axis.parent_segment];
            // Frames that do not twist differ by one angle from end to end.
            Vec3 const normal = first_normal(along[0].tangent, bearer);
            double const cosine = normal.dot(along[0].normal);
            double const sine = normal.dot(along[0].binormal());
            for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
                auto const& [tangent, side] = along[i];
                shape.frame[axis.first_segment + i]
                    = { tangent, cosine * side + sine * along[i].binormal() };
                shape.length_mm[axis.first_segment + i] = (nodes[i + 1] - nodes[i]).norm();
            }
        }
    });
    return shape;
}

// Takes coordinates in the frame (tangent, normal, binormal) to those that the frame is given in.
Quat rotation_of(Frame const& frame)
{
    Eigen::Matrix3d columns;
    columns << frame.tangent, frame.normal, frame.binormal();
    return Quat(columns);
}

// Lays strokes along segments of one plant. Its result is a rotation per joint: how much the
// segment turns against the one below, compared with the base plant. So what bears a branch can
// change without the branch's own shape being touched.
class JointBender {
public:
    JointBender(Plant const& plant, BaseShape const& base)
        : plant_(plant)
        , base_(base)
        , joints_(plant.segment_count(), Quat::Identity())
    {
    }

    Result<void> apply(Association const& association);

    std::vector<Quat> take_joints() && { return std::move(joints_); }

private:
    Result<void> check_path(std::span<SegmentId const> path) const;
    template<typename SegmentAt>
    void bend(std::size_t count, SegmentAt const& segment_at, ArcLength const& curve,
              Quat const& to_base);
    std::vector<AxisId> descendants(std::span<SegmentId const> path) const;
    void bend_descendants(std::span<SegmentId const> path, ArcLength const& curve,
                          Quat const& to_base);

    Plant const& plant_;
    BaseShape const& base_;
    std::vector<Quat> joints_;
};

Result<void> JointBender::check_path(std::span<SegmentId const> path) const
{
    if (path.empty())
        return fail(Fault::User, "no branch is selected for the stroke: select one first");
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (path[i] >= plant_.segment_count())
            return fail(Fault::User,
                        fmt::format("segment {} is not in the plant, which has {}: select "
                                    "the branch again",
                                    path[i], plant_.segment_count()));
        if (i > 0 && parent_segment(plant_, path[i]) != path[i - 1])
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
        if (chord.norm() > 0.01 * share * curve.length_mm()) // Else it turns back at once.
            return chord.normalized();
    }
    Vec3 const chord = curve.at(0.5) - curve.at(0);
    return chord.isZero(0) ? Vec3(Vec3::UnitZ()) : Vec3(chord.normalized());
}

Result<void> JointBender::apply(Association const& association)
{
    TRY(check_path(association.path));
    if (!(association.kept_hand >= 0 && association.kept_hand <= 1))
        return fail(Fault::User,
                    fmt::format("{} of the hand cannot be kept: give a share from 0 to 1",
                                association.kept_hand));
    auto const points = TRY(stroke_points(association.stroke));
    ArcLength const curve(smooth_hand(points, association.kept_hand));
    auto const& first = base_.frame[association.path.front()];
    Quat const to_base = least_rotation(start_tangent(curve), first.tangent);

    auto const segment_at = [&](std::size_t i) { return association.path[i]; };
    if (association.propagation != Propagation::Descendants)
        bend(association.path.size(), segment_at, curve, to_base);
    if (association.propagation != Propagation::Selected)
        bend_descendants(association.path, curve, to_base);
    return {};
}

// Gives the segments segment_at(0) to segment_at(count - 1), each the child of the one before, the
// shape of `curve` turned by `to_base`.
template<typename SegmentAt>
void JointBender::bend(std::size_t count, SegmentAt const& segment_at, ArcLength const& curve,
                       Quat const& to_base)
{
    double total_mm = 0;
    for (std::size_t i = 0; i < count; ++i)
        total_mm += base_.length_mm[segment_at(i)];
    if (!(total_mm > 0))
        return;

    double sum_mm = 0;
    Vec3 from = curve.at(0);
    Vec3 base_before = base_.frame[segment_at(0)].tangent;
    Vec3 bent_before = base_before;
    Quat turn_before = Quat::Identity(); // From the base plant, of the segment below.
    for (std::size_t i = 0; i < count; ++i) {
        SegmentId const segment = segment_at(i);
        sum_mm += base_.length_mm[segment];
        Vec3 const to = curve.at(sum_mm / total_mm);
        Vec3 const& base = base_.frame[segment].tangent;
        // Where the hand turned back on itself the chord has no direction: go straight on.
        Vec3 const chord = to_base * (to - from);
        Vec3 const bent = chord.isZero(0) ? bent_before : Vec3(chord.normalized());
        // Both curves are followed without twist; what differs is the segment's own rotation.
        Quat const turn = (least_rotation(bent_before, bent) * turn_before
                           * least_rotation(base_before, base).conjugate())
                              .normalized();
        joints_[segment] = turn_before.conjugate() * turn;
        from = to;
        base_before = base;
        bent_before = bent;
        turn_before = turn;
    }
}

// The axes that the path bears, without those that it runs along itself.
std::vector<AxisId> JointBender::descendants(std::span<SegmentId const> path) const
{
    std::vector<bool> below(plant_.segment_count()); // The path and what it bears.
    std::vector<bool> has_path(plant_.axes.size());
    for (auto const segment : path) {
        below[segment] = true;
        has_path[axis_of(plant_, segment)] = true;
    }
    std::vector<AxisId> found;
    for (AxisId id = 0; id < plant_.axes.size(); ++id) { // Bearers come first.
        auto const& axis = plant_.axes[id];
        bool reached = axis.parent_segment != kNone && below[axis.parent_segment];
        if (reached && !has_path[id])
            found.push_back(id);
        for (std::uint32_t i = 0; i < axis.segment_count; ++i)
            below[axis.first_segment + i] = reached = reached || below[axis.first_segment + i];
    }
    return found;
}

void JointBender::bend_descendants(std::span<SegmentId const> path, ArcLength const& curve,
                                   Quat const& to_base)
{
    Quat const from_path = rotation_of(base_.frame[path.front()]).conjugate() * to_base;
    auto const axes = descendants(path);
    constexpr std::size_t kAxesPerPiece = 64;
    // Each axis has its own joints, so any order will do.
    parallel_for(axes.size(), kAxesPerPiece, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const& axis = plant_.axes[axes[i]];
            Quat const to_axis = rotation_of(base_.frame[axis.first_segment]) * from_path;
            auto const segment_at
                = [&](std::size_t n) { return axis.first_segment + static_cast<SegmentId>(n); };
            bend(axis.segment_count, segment_at, curve, to_axis);
        }
    });
}

} // namespace

Result<PredefinedShape> resolve_associations(Plant const& plant,
                                             std::span<Association const> associations)
{
    auto const levels = find_axis_levels(plant);
    auto base = base_shape(plant, levels);
    JointBender bender(plant, base);
    for (auto const& association : associations)
        TRY(bender.apply(association));
    auto const joints = std::move(bender).take_joints();

    PredefinedShape shape { .frame = std::move(base.frame) };
    shape.rotation.assign(plant.segment_count(), Quat::Identity());
    for_each_level(levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes) {
            auto const& axis = plant.axes[id];
            Quat rotation = axis.parent_segment == kNone ? Quat::Identity()
                                                         : shape.rotation[axis.parent_segment];
            for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
                SegmentId const segment = axis.first_segment + i;
                rotation = (rotation * joints[segment]).normalized();
                shape.rotation[segment] = rotation;
                auto& frame = shape.frame[segment];
                frame.tangent = (rotation * frame.tangent).normalized();
                frame.normal = normal_towards(frame.tangent, rotation * frame.normal);
            }
        }
    });
    return shape;
}

} // namespace tractus
