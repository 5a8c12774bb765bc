#pragma once

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <vector>

namespace tractus::leaf {

// Half of a blade's margin in the flat leaf, from the petiole's end at (0, 0) to the tip: x to the
// right of the leaf's axis, y along it. The curve passes through the points and can have corners at
// them.
struct HalfOutline {
    struct Point {
        Vec2 at = Vec2::Zero();
        bool is_corner = false;

        bool operator==(Point const&) const = default;
    };
    // Points of the half outline; empty if the grammar has no outline.
    std::vector<Point> points {};

    enum class Margin { Entire, Teeth, Scallops };
    Margin margin = Margin::Entire;
    int count = 0;    // Number of teeth or scallops on this half.
    double depth = 0; // Depth of the teeth, as a length. It decreases towards both ends.
    double lean = 0;  // Lean of the teeth towards the tip, 0 to 1.
};

// The whole margin of one leaf: a closed polyline, counter-clockwise from the petiole's end.
class Outline {
public:
    // Standard deviations of the random variation between leaves.
    struct Variation {
        double width = 0.06; // Standard deviation of the factor on the outline's width.
        // Standard deviation of the position of each point, as a share of the half's size.
        double point = 0.012;
    };

    // Makes an outline of two equal halves, whose points vary independently. If the half has no
    // points, the outline is empty().
    Outline(HalfOutline const& half, Variation const& variation, Random& random)
        : Outline(half, half, variation, random)
    {
    }

    // Makes an outline of two different halves with a common tip. In `left_half` x is positive to
    // the left.
    Outline(HalfOutline const& right_half, HalfOutline const& left_half, Variation const& variation,
            Random& random);

    bool empty() const { return line_.empty(); }
    std::vector<Vec2> const& line() const { return line_; }

    // Returns the distance from a point to the outline in a direction; 0 if the ray misses the
    // outline.
    double reach(Vec2 const& from, Vec2 const& direction) const;

    // Returns the outline's points between `from` and `to`, counter-clockwise. Empty if either
    // place is farther than `tolerance` from the outline, or if more than 0.7 of the outline's
    // points lie between them.
    std::vector<Vec2> between(Vec2 const& from, Vec2 const& to, double tolerance) const;

    // True if at most 0.7 of the outline's points lie between `from` and `to`, counter-clockwise.
    bool goes_forward(Vec2 const& from, Vec2 const& to) const;

private:
    struct Place {
        double along = 0; // Position on the outline as a fractional index.
        double distance = 0;
    };
    // Part of the outline, with its bounding circle for fast rejection.
    struct Part {
        // First point of the part; `end`: one past its last point. Each point stands for the
        // segment to the next point.
        std::size_t begin = 0;
        std::size_t end = 0;
        Vec2 middle = Vec2::Zero();
        double radius = 0;
    };
    void find_parts();
    void look_at(Part const& part, Vec2 const& point, Place& best) const;
    Place nearest(Vec2 const& point) const;
    double span(Place const& from, Place const& to) const;
    bool is_forward(Place const& from, Place const& to) const;

    std::vector<Vec2> line_;
    std::vector<Part> parts_;
};

} // namespace tractus::leaf
