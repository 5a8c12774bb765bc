#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace tractus::leaf {

// Triangles of a flat area, to which points and lines can be added. After each change the triangles
// are a constrained Delaunay triangulation: as far from slivers as the area's border and its lines
// allow (Lawson, "Software for C1 surface interpolation", 1977).
class FlatMesh {
public:
    using Corner = std::uint32_t;
    using Triangle = std::array<Corner, 3>;

    // Triangulates closed contours: outer ones counter-clockwise, y upwards, and holes clockwise.
    // They must not cross. A hole that lies in no outer contour is left out.
    explicit FlatMesh(std::span<std::vector<Vec2> const> contours);

    std::vector<Vec2> const& points() const { return points_; }
    // Triangles, counter-clockwise.
    std::vector<Triangle> triangles() const;

    // Adds a point and returns its number; no value if it lies outside the area or on a point that
    // is there.
    std::optional<Corner> add_point(Vec2 const& at);

    // Makes the line between two points an edge that stays. Returns false if the border, or a line
    // that was added before, is in the way.
    bool add_line(Corner from, Corner to);

private:
    // Edge k goes from corner k to the next one; `across` has the triangle on its other side, or
    // kNone.
    static constexpr std::int32_t kNone = -1;
    struct Face {
        Triangle corners {};
        std::array<std::int32_t, 3> across { kNone, kNone, kNone };
    };
    // An edge, given by one of its triangles.
    struct Edge {
        std::int32_t face = kNone;
        unsigned k = 0;
    };

    void add_contours(std::span<std::vector<Vec2> const> contours);
    void add_area(std::vector<Corner> const& ring);
    void link_faces();
    Face& face(std::int32_t number) { return faces_[static_cast<std::size_t>(number)]; }
    Face const& face(std::int32_t number) const { return faces_[static_cast<std::size_t>(number)]; }
    Edge other_side(Edge const& edge) const;
    void relink(std::int32_t neighbour, Corner from, std::int32_t now);
    bool is_line(Corner a, Corner b) const;
    bool can_flip(Edge const& edge) const;
    void flip(Edge const& edge);
    void improve(std::vector<Edge> pending);
    void improve_all();
    std::optional<Edge> crossing(Corner from, Corner to) const;
    bool has_edge(Corner from, Corner to) const;

    std::vector<Vec2> points_;
    std::vector<Face> faces_;
    std::set<std::pair<Corner, Corner>> lines_;
};

} // namespace tractus::leaf
