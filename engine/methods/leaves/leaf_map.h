#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::leaf {

// Darts, vertices and faces are numbered from 0.
using Dart = std::int32_t;
using Vertex = std::int32_t;
using FaceId = std::int32_t;

// Label of an edge within its face: O is the edge on which the face was grown, E the opposite edge,
// C1, C2, … are the sides.
enum class EdgeLabel : std::uint16_t { Origin, Extremity, FirstSide, LimbSide = 0xFFFE, LimbEnd };

// Label C<number>, counting from 1.
constexpr EdgeLabel side_label(int number)
{
    return static_cast<EdgeLabel>(static_cast<int>(EdgeLabel::FirstSide) + number - 1);
}

// Returns the labels of the edges of a face with this many edges (at least 3), counter-clockwise
// from O: the right sides, E, the left sides. A quadrilateral has O C1 E C2.
std::vector<EdgeLabel> edge_labels(int edge_count);

bool has_edge(int edge_count, EdgeLabel label);

// Numbers of a map's cells, connected components and border parts.
struct MapCounts {
    std::size_t faces = 0;
    std::size_t edges = 0;
    std::size_t vertices = 0;
    std::size_t darts = 0;
    std::size_t components = 0;
    std::size_t border_edges = 0;
    std::size_t border_cycles = 0;
    // Number of triangles after triangulation: a face of n edges gives n - 2.
    std::size_t triangles = 0;

    std::ptrdiff_t euler_characteristic() const
    {
        return static_cast<std::ptrdiff_t>(vertices + faces) - static_cast<std::ptrdiff_t>(edges);
    }
};

// A 2-G-map (Lienhardt, "N-dimensional generalized combinatorial maps and cellular
// quasi-manifolds", 1994) with closed faces, embedded in space.
//
// Each edge of a face has two darts: 2i at its counter-clockwise start and 2i + 1 at its end, so a0
// needs no storage. a1 is the dart of the neighbouring edge at the same vertex of the face. a2 is
// the dart at the same vertex in the adjacent face, or the dart itself on the border. Each vertex
// has a position in space and one in the flat leaf, which neither bends nor twists.
class LeafMap {
public:
    static Dart a0(Dart d) { return d ^ 1; }
    Dart a1(Dart d) const { return a1_[index(d)]; }
    Dart a2(Dart d) const { return a2_[index(d)]; }
    Vertex vertex(Dart d) const { return vertex_[index(d)]; }
    FaceId face(Dart d) const { return face_[index(d)]; }
    EdgeLabel label(Dart d) const { return label_[index(d)]; }
    Vec3 const& position(Vertex v) const { return positions_[index(v)]; }
    Vec3 const& position_of(Dart d) const { return position(vertex(d)); }
    Vec2 const& flat(Vertex v) const { return flat_[index(v)]; }
    Vec2 const& flat_of(Dart d) const { return flat(vertex(d)); }
    bool is_free(Dart d) const { return a2(d) == d; }
    std::size_t dart_count() const { return a1_.size(); }
    // Number of vertices, including those that were merged into others and are no longer used.
    std::size_t vertex_count() const { return positions_.size(); }

    // Adds a vertex; `flat` is its position in the flat leaf.
    Vertex add_vertex(Vec3 const& position, Vec2 const& flat);
    Vertex add_vertex(Vec3 const& position) { return add_vertex(position, position.head<2>()); }

    // Adds a face with these corners, counter-clockwise; edge i starts at corner i. Returns the
    // start dart of edge 0; the darts of the other edges have the following numbers.
    Dart add_face(std::span<Vertex const> corners, FaceId face, std::span<EdgeLabel const> labels);

    // Sews the free edge of d to that of e. The vertices of d and e are merged at their midpoint,
    // and likewise those at the edges' other ends.
    void sew(Dart d, Dart e);
    // Sews the free edge of d to that of e if their end points already coincide.
    void sew_in_place(Dart d, Dart e);
    // Separates the sewn edge of d into two free edges.
    void unsew(Dart d);

    // Splits the edge of d, which may be sewn, at `share` of its length from d. d keeps its vertex;
    // returns the other dart of d's half, which is at the new vertex. On the other side of a sewn
    // edge, the dart joined to d keeps its vertex as well.
    Dart insert_vertex(Dart d, double share);

    // Splits a face by a new edge from the end of e1's edge to the end of e2's. The edges that
    // follow e1 form the face `far`, where the new edge has the label `far_label`; the rest keeps
    // its face. Returns the start dart of the new edge in `far`.
    Dart insert_edge(Dart e1, Dart e2, FaceId far, EdgeLabel near_label, EdgeLabel far_label);

    // Removes all darts with this number or a higher one, which belong to the most recently added
    // faces.
    void truncate(std::size_t dart_count);

    // The start darts of a face's edges, counter-clockwise, beginning with d's edge.
    std::vector<Dart> cycle(Dart d) const;

    // Takes the start dart of a free edge; returns the start dart of the next free edge along the
    // border.
    Dart next_on_border(Dart d) const;
    std::vector<Dart> border(Dart d) const;

    MapCounts counts() const;

    // Describes a violation of the axioms of an orientable 2-G-map with closed faces; empty if
    // there is none.
    std::string fault() const;

private:
    static std::size_t index(std::int32_t number) { return static_cast<std::size_t>(number); }
    Dart add_edge(Vertex start, Vertex end, FaceId face, EdgeLabel label);
    void link1(Dart d, Dart e);
    void link2(Dart d, Dart e);
    void merge(Dart d, Dart e);
    Dart halve(Dart d, Vertex middle);
    template<typename Visit> void visit_cell(Dart d, unsigned maps, Visit const& visit) const;
    std::size_t count_cells(unsigned maps) const;
    bool is_oriented() const;

    std::vector<Dart> a1_;
    std::vector<Dart> a2_;
    std::vector<Vertex> vertex_;
    std::vector<FaceId> face_;
    std::vector<EdgeLabel> label_;
    std::vector<Vec3> positions_;
    std::vector<Vec2> flat_;
};

} // namespace tractus::leaf
