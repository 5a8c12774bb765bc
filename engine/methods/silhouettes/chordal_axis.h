#pragma once

#include "engine/methods/silhouettes/triangulation.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Points of an outline from one to another along it, both among them: the way may lead over its
// first point.
struct Arc {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    std::size_t inner_count(std::size_t points) const // Without the two ends.
    {
        return (last + points - first) % points - (first == last ? 0 : 1);
    }
};

// A chord of an outline: an edge of a triangle that is not the outline's own. It looks away from
// its triangle.
struct Chord {
    std::uint32_t triangle = 0;
    std::uint32_t edge = 0;

    bool operator==(Chord const&) const = default;
};

// The triangles of an outline as a tree: neighbours across chords (Prasad, "Morphological analysis
// of shapes", 1997). A triangle with one chord is terminal: the tip of something; with two a
// sleeve; with three a junction, where three parts meet.
class ChordalAxis {
public:
    // A simple outline, counter-clockwise, of at least three points.
    explicit ChordalAxis(std::vector<Vec2> outline);

    std::vector<Vec2> const& outline() const { return outline_; }
    std::vector<Triangle> const& triangles() const { return triangles_; }

    // 0 to 3; 0 only where the whole outline is one triangle.
    int chord_count(std::uint32_t triangle) const;

    struct Counts {
        std::size_t terminal = 0;
        std::size_t sleeve = 0;
        std::size_t junction = 0;
    };
    Counts counts() const;

    // The outline beyond a chord, from one of its ends to the other.
    Arc beyond(Chord const& chord) const;
    Vec2 const& first_of(Chord const& chord) const { return outline_[beyond(chord).first]; }
    Vec2 const& last_of(Chord const& chord) const { return outline_[beyond(chord).last]; }
    double length_of(Chord const& chord) const { return (last_of(chord) - first_of(chord)).norm(); }

    // The same chord as its other triangle sees it.
    Chord reversed(Chord const& chord) const;

    // The other chords of the triangle that lies beyond.
    std::vector<Chord> onward(Chord const& chord) const;

    // How far the outline beyond a chord rises out of the circumcircle of its triangle: 0 or more,
    // but for rounding.
    double rise(Chord const& chord) const;

private:
    std::vector<Vec2> outline_;
    std::vector<Triangle> triangles_;
};

// Center and radius of the circle through three points that are not on a line.
struct Circle {
    Vec2 center = Vec2::Zero();
    double radius = 0;
};
Circle circumcircle(Vec2 const& a, Vec2 const& b, Vec2 const& c);

} // namespace tractus::silhouette
