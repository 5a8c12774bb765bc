#pragma once

#include "engine/methods/silhouettes/triangulation.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// A run of outline points, both ends included. It may wrap around past the last point.
struct Arc {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    // Number of points of the arc without its two ends.
    std::size_t inner_count(std::size_t points) const
    {
        return (last + points - first) % points - (first == last ? 0 : 1);
    }
};

// A chord: an edge of a triangle that is not an edge of the outline, seen from inside this
// triangle.
struct Chord {
    std::uint32_t triangle = 0;
    std::uint32_t edge = 0;

    bool operator==(Chord const&) const = default;
};

// The triangulation of an outline as a tree whose edges are the chords between neighbouring
// triangles (Prasad, "Morphological analysis of shapes", 1997). A triangle with one chord is
// terminal (a tip), one with two is a sleeve, one with three is a junction of three parts.
class ChordalAxis {
public:
    // `outline`: a simple polygon, counter-clockwise, at least three points.
    explicit ChordalAxis(std::vector<Vec2> outline);

    std::vector<Vec2> const& outline() const { return outline_; }
    std::vector<Triangle> const& triangles() const { return triangles_; }

    // Number of chords of a triangle, 0 to 3; 0 only if the whole outline is one triangle.
    int chord_count(std::uint32_t triangle) const;

    struct Counts {
        std::size_t terminal = 0;
        std::size_t sleeve = 0;
        std::size_t junction = 0;
    };
    Counts counts() const;

    // The part of the outline beyond a chord, from one end of the chord to the other.
    Arc beyond(Chord const& chord) const;
    Vec2 const& first_of(Chord const& chord) const { return outline_[beyond(chord).first]; }
    Vec2 const& last_of(Chord const& chord) const { return outline_[beyond(chord).last]; }
    double length_of(Chord const& chord) const { return (last_of(chord) - first_of(chord)).norm(); }

    // Returns the chord as an edge of the triangle on its other side.
    Chord reversed(Chord const& chord) const;

    // The other chords of the triangle on the far side of a chord.
    std::vector<Chord> onward(Chord const& chord) const;

    // Distance by which the outline beyond a chord protrudes from the circumcircle of the chord's
    // triangle: 0 or more, up to rounding.
    double rise(Chord const& chord) const;

private:
    std::vector<Vec2> outline_;
    std::vector<Triangle> triangles_;
};

// Centre and radius of the circle through three points that are not collinear.
struct Circle {
    Vec2 center = Vec2::Zero();
    double radius = 0;
};
Circle circumcircle(Vec2 const& a, Vec2 const& b, Vec2 const& c);

} // namespace tractus::silhouette
