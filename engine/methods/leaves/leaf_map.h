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

// An edge's name within its face: O is the edge at which the face was grown, E the one across from
// it, C1, C2, … are the sides.
enum class EdgeLabel : std::uint16_t { Origin, Extremity, FirstSide, LimbSide = 0xFFFE, LimbEnd };

// C1 for 1 and so on.
constexpr EdgeLabel side_label(int number)
{
    return static_cast<EdgeLabel>(static_cast<int>(EdgeLabel::FirstSide) + number - 1);
}

// The labels of a face of so many edges, 3 or more, counter-clockwise from O: the right sides, E,
// the left sides. A quad has O C1 E C2.
std::vector<EdgeLabel> edge_labels(int edge_count);

bool has_edge(int edge_count, EdgeLabel label);

// How many cells of each kind there are.
struct MapCounts {
    std::size_t faces = 0;
    std::size_t edges = 0;
    std::size_t vertices = 0;
    std::size_t darts = 0;
    std::size_t components = 0;
    std::size_t border_edges = 0;
    std::size_t border_cycles = 0;
    // Triangles that the faces can be cut into: n - 2 for each of n edges.
    std::size_t triangles = 0;

    std::ptrdiff_t euler_characteristic() const
    {
        return static_cast<std::ptrdiff_t>(vertices + faces) - static_cast<std::ptrdiff_t>(edges);
    }
};

// A 2-G-map (Lienhardt, "N-dimensional generalized combinatorial maps and cellular
// quasi-manifolds", 1994) whose faces are closed, embedded in space, and its vertices.
//
// Each edge of a face has two darts: 2i, where it starts counter-clockwise round the face, and
// 2i + 1, where it ends; so a0 needs no array. a1 leads to the neighbouring edge's dart at the same
// vertex of the face, a2 to the dart at the same vertex of the face on the other side, or to itself
// on the border. Each vertex has its place in space and in the flat leaf, which neither bends nor
// twists.
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
    std::size_t vertex_count() const { return positions_.size(); } // Merged ones counted as well.

    // `flat` is its place in the flat leaf.
    Vertex add_vertex(Vec3 const& position, Vec2 const& flat);
    Vertex add_vertex(Vec3 const& position) { return add_vertex(position, position.head<2>()); }

    // Adds a face with these corners, counter-clockwise; edge i starts at corner i. Returns the
    // dart that starts edge 0; the others follow it.
    Dart add_face(std::span<Vertex const> corners, FaceId face, std::span<EdgeLabel const> labels);

    // Joins two free edges: d and e, ends of them, come to lie together, and so do their other
    // ends, each halfway between the two.
    void sew(Dart d, Dart e);
    // Sews two edges whose ends lie together already.
    void sew_in_place(Dart d, Dart e);
    // The edge of d is two again.
    void unsew(Dart d);

    // Cuts the edge of d, which may be sewn, at `share` of the way from d. d keeps its vertex;
    // gives the dart across from d, which comes to lie at the new one. On the other side of a sewn
    // edge the dart that is joined with d keeps its vertex in the same way.
    Dart insert_vertex(Dart d, double share);

    // Parts a face: the new edge runs from the vertex where e1 ends its edge to that where e2 does.
    // The edges that follow e1 become the face `far`, on whose side the new edge is labelled
    // `far_label`; the rest keeps its face. Gives the dart that starts the new edge in `far`.
    Dart insert_edge(Dart e1, Dart e2, FaceId far, EdgeLabel near_label, EdgeLabel far_label);

    // Takes away everything from this dart on: faces that were added last.
    void truncate(std::size_t dart_count);

    // The darts that start the edges of a face, from d's edge on, counter-clockwise.
    std::vector<Dart> cycle(Dart d) const;

    // Leads from the start of a free edge to that of the next one on the border.
    Dart next_on_border(Dart d) const;
    std::vector<Dart> border(Dart d) const;

    MapCounts counts() const;

    // Returns what contradicts the axioms of a 2-G-map with closed faces that can be oriented;
    // empty if nothing does.
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
