#include "engine/variation/similar_branches.h"

#include "engine/plant/branch_address.h"
#include "engine/plant/join_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::variation {

namespace {

Vec3 chord_of(Plant const& plant, Axis const& axis)
{
    auto const nodes = plant.positions(axis);
    return nodes.back() - nodes.front();
}

// Position of the segment's end along its axis, as a share of the axis' number of segments.
double share_of(Axis const& axis, SegmentId segment)
{
    return static_cast<double>(segment - axis.first_segment + 1) / axis.segment_count;
}

double height_of(Plant const& plant)
{
    auto const box = bounds(plant);
    return box.empty() ? 1 : std::max(1e-9, box.max_mm.z() - box.min_mm.z());
}

// Returns how much two axes differ; 0 for equal ones. It is the sum of the weighted difference of
// their positions on their parent axes (share_of()), the angle between their chords in radians, and
// the natural logarithm of the ratio of the chords' lengths. Axes on the ground are compared by the
// distance of their bases, as a share of the plant's height.
double difference(Plant const& one, Axis const& a, Plant const& other, Axis const& b)
{
    constexpr double kPlaceWeight = 3;
    Vec3 const chord_a = chord_of(one, a);
    Vec3 const chord_b = chord_of(other, b);
    double const lengths = std::max(1e-9, chord_a.norm()) / std::max(1e-9, chord_b.norm());
    double const place = a.parent_segment == kNone
        ? (one.node_position_mm[a.first_node] - other.node_position_mm[b.first_node]).norm()
            / height_of(one)
        : std::abs(share_of(one.axes[a.parent_axis], a.parent_segment)
                   - share_of(other.axes[b.parent_axis], b.parent_segment));
    double const angle = std::atan2(chord_a.cross(chord_b).norm(), chord_a.dot(chord_b));
    return kPlaceWeight * place + angle + std::abs(std::log(lengths));
}

} // namespace

SimilarBranches::SimilarBranches(Plant const& from, Plant const& to)
    : from_(from)
    , to_(to)
    , borne_(to.axes.size() + 1)
{
    for (AxisId id = 0; id < to.axes.size(); ++id)
        borne_[to.axes[id].parent_axis == kNone ? to.axes.size() : to.axes[id].parent_axis]
            .push_back(id);
}

std::optional<AxisId> SimilarBranches::similar_axis(AxisId axis)
{
    if (auto const known = found_.find(axis); known != found_.end())
        return known->second;
    auto const& wanted = from_.axes[axis];
    auto& found = found_[axis];
    std::size_t bearer = to_.axes.size();
    if (wanted.parent_axis != kNone) {
        auto const like_bearer = similar_axis(wanted.parent_axis);
        if (!like_bearer)
            return std::nullopt;
        bearer = *like_bearer;
    }
    double least = std::numeric_limits<double>::infinity();
    for (auto const id : borne_[bearer]) {
        double const differs = difference(from_, wanted, to_, to_.axes[id]);
        if (!taken_.contains(id) && differs < least) {
            least = differs;
            found = id;
        }
    }
    if (found) {
        taken_.insert(*found);
        greatest_difference_ = std::max(greatest_difference_, least);
    }
    return found;
}

std::optional<SegmentId> SimilarBranches::similar_segment(SegmentId segment)
{
    auto const axis = axis_of(from_, segment);
    auto const found = similar_axis(axis);
    if (!found)
        return std::nullopt;
    auto const& wanted = from_.axes[axis];
    auto const& like = to_.axes[*found];
    double const at = share_of(wanted, segment) * like.segment_count;
    auto const number = std::clamp(std::lround(at), 1L, static_cast<long>(like.segment_count));
    // The first segment of an axis always corresponds to the first segment of the similar axis.
    bool const is_first = segment == wanted.first_segment;
    return like.first_segment + (is_first ? 0 : static_cast<SegmentId>(number - 1));
}

std::optional<std::vector<SegmentId>> SimilarBranches::like(std::vector<SegmentId> const& path)
{
    auto const first = similar_segment(path.front());
    auto const last = similar_segment(path.back());
    if (!first || !last)
        return std::nullopt;
    if (auto between = path_between(to_, *first, *last))
        return between;
    // In the other plant the similar branch leaves its parent below the segment at which the path
    // would begin, so the path begins at the base of that segment's axis.
    auto const& axis = to_.axes[axis_of(to_, *first)];
    return path_between(to_, axis.first_segment, *last);
}

} // namespace tractus::variation
