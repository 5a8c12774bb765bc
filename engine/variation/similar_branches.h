#pragma once

#include "engine/plant/plant.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tractus::variation {

// Finds, for branches of one plant, the most similar branches of another individual of its kind,
// which may differ in the number and positions of its branches. Two branches are similar if they
// leave similar parents at a similar height, in a similar direction, and are similarly long. Each
// branch of the other plant is found for at most one branch.
class SimilarBranches {
public:
    // Both plants must outlive the object.
    SimilarBranches(Plant const& from, Plant const& to);

    // Returns the path between the segments that lie at the same share of the length of the
    // similar branches. `path` as in Association: not empty, from the ground towards a tip. No
    // value if the other plant has no such branch.
    std::optional<std::vector<SegmentId>> like(std::vector<SegmentId> const& path);

    // Greatest difference between a branch found so far and the one it was found for. A difference
    // is the sum of three times the difference in height as a share of the parent axis, the angle
    // between the chords in radians, and the natural logarithm of the ratio of the lengths.
    double greatest_difference() const { return greatest_difference_; }

private:
    std::optional<AxisId> similar_axis(AxisId axis);
    std::optional<SegmentId> similar_segment(SegmentId segment);

    Plant const& from_;
    Plant const& to_;
    std::vector<std::vector<AxisId>> borne_; // Laterals of each axis of to_; last, of the ground.
    std::map<AxisId, std::optional<AxisId>> found_;
    std::set<AxisId> taken_;
    double greatest_difference_ = 0;
};

} // namespace tractus::variation
