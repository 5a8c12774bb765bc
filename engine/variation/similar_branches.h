#pragma once

#include "engine/plant/plant.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tractus::variation {

// Finds, for branches of one plant, the most similar branches of another plant of the same kind.
// The plants may differ in the number and positions of their branches. Two branches are similar if
// they leave similar parents at a similar height and in a similar direction, and if they are
// similarly long. Each branch of the other plant is matched at most once.
class SimilarBranches {
public:
    // Both plants must outlive the object.
    SimilarBranches(Plant const& from, Plant const& to);

    // Returns the corresponding path in the other plant: its ends are at the same shares of the
    // similar branches as the ends of `path`. `path` is one of Association: not empty, from the
    // ground towards a tip. Returns no value if the other plant has no similar branches.
    std::optional<std::vector<SegmentId>> like(std::vector<SegmentId> const& path);

    // Greatest difference, so far, between a branch and the similar one found for it. A difference
    // is the sum of three times the difference of the positions on the parent axes (as shares of
    // their segments), the angle between the chords in radians, and the natural logarithm of the
    // ratio of the chords' lengths.
    double greatest_difference() const { return greatest_difference_; }

private:
    std::optional<AxisId> similar_axis(AxisId axis);
    std::optional<SegmentId> similar_segment(SegmentId segment);

    Plant const& from_;
    Plant const& to_;
    // Laterals of each axis of to_; the last entry has the axes on the ground.
    std::vector<std::vector<AxisId>> borne_;
    std::map<AxisId, std::optional<AxisId>> found_;
    std::set<AxisId> taken_;
    double greatest_difference_ = 0;
};

} // namespace tractus::variation
