#pragma once

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <vector>

namespace tractus::leaf {

// Half a blade's margin in the flat leaf, from the stalk's end at (0, 0) to the tip: x to the right
// of the leaf's axis, y along it. The curve passes through the points and breaks at corners.
struct HalfOutline {
    struct Point {
        Vec2 at = Vec2::Zero();
        bool is_corner = false;

        bool operator==(Point const&) const = default;
    };
    std::vector<Point> points {}; // None: the grammar has no outline.

    enum class Margin { Entire, Teeth, Scallops };
    Margin margin = Margin::Entire;
    int count = 0;    // Number of teeth or scallops, on this half.
    double depth = 0; // Theirs, as a length; they fade towards both ends.
    double lean = 0;  // 0 to 1: how far they point towards the tip.
};

// The whole margin of one leaf: a closed line, counter-clockwise from the stalk's end.
class Outline {
public:
    // How far one leaf differs from the next: standard deviations.
    struct Variation {
        double width = 0.06;  // Variation of the factor on x.
        double point = 0.012; // Variation of each point's place, as a share of the blade's length.
    };

    // No points: an outline that nothing reaches. The halves vary each by itself.
    Outline(HalfOutline const& half, Variation const& variation, Random& random)
        : Outline(half, half, variation, random)
    {
    }

    // Halves that differ end at one tip; the left one's x is to the left.
    Outline(HalfOutline const& right_half, HalfOutline const& left_half, Variation const& variation,
            Random& random);

    bool empty() const { return line_.empty(); }
    std::vector<Vec2> const& line() const { return line_; }

    // How far the outline is from there in that direction; 0 where the way meets none.
    double reach(Vec2 const& from, Vec2 const& direction) const;

    // The points of the line on the way from beside `from` to beside `to`, counter-clockwise. None
    // where one of them is farther than `tolerance` from the line or the way is most of it.
    std::vector<Vec2> between(Vec2 const& from, Vec2 const& to, double tolerance) const;

    // Whether the way along the line from beside `from` to beside `to`, counter-clockwise, is not
    // most of it.
    bool goes_forward(Vec2 const& from, Vec2 const& to) const;

private:
    struct Place {
        double along = 0; // Place in points of the line.
        double distance = 0;
    };
    // A piece of the line in a circle, so that what is elsewhere need not be looked at.
    struct Part {
        std::size_t begin = 0; // Points; each with the way to the next one.
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
