#include "engine/methods/leaves/leaf_map.h"

#include "engine/base/check.h"

#include <utility>

namespace tractus::leaf {

namespace {

// Bits that stand for the involutions a0, a1 and a2, which lead from one dart of a cell to another.
constexpr unsigned kA0 = 1;
constexpr unsigned kA1 = 2;
constexpr unsigned kA2 = 4;

bool starts(Dart d)
{
    return (d & 1) == 0;
}

} // namespace

std::vector<EdgeLabel> edge_labels(int edge_count)
{
    CHECK(edge_count >= 3);
    int const rights = (edge_count - 1) / 2;
    std::vector<EdgeLabel> labels { EdgeLabel::Origin };
    for (int side = 1; side <= edge_count - 2; ++side) {
        if (side == rights + 1)
            labels.push_back(EdgeLabel::Extremity);
        labels.push_back(side_label(side));
    }
    if (rights == edge_count - 2)
        labels.push_back(EdgeLabel::Extremity);
    return labels;
}

bool has_edge(int edge_count, EdgeLabel label)
{
    return label == EdgeLabel::Origin || label == EdgeLabel::Extremity
        || label <= side_label(edge_count - 2);
}

Vertex LeafMap::add_vertex(Vec3 const& position, Vec2 const& flat)
{
    positions_.push_back(position);
    flat_.push_back(flat);
    return static_cast<Vertex>(positions_.size() - 1);
}

// Adds the two darts of an edge that is not connected to any other.
Dart LeafMap::add_edge(Vertex start, Vertex end, FaceId face, EdgeLabel label)
{
    auto const first = static_cast<Dart>(dart_count());
    for (auto const vertex : { start, end }) {
        auto const d = static_cast<Dart>(dart_count());
        a1_.push_back(d);
        a2_.push_back(d);
        vertex_.push_back(vertex);
        face_.push_back(face);
        label_.push_back(label);
    }
    return first;
}

void LeafMap::link1(Dart d, Dart e)
{
    a1_[index(d)] = e;
    a1_[index(e)] = d;
}

void LeafMap::link2(Dart d, Dart e)
{
    a2_[index(d)] = e;
    a2_[index(e)] = d;
}

Dart LeafMap::add_face(std::span<Vertex const> corners, FaceId face,
                       std::span<EdgeLabel const> labels)
{
    auto const first = static_cast<Dart>(dart_count());
    auto const count = corners.size();
    for (std::size_t i = 0; i < count; ++i)
        add_edge(corners[i], corners[(i + 1) % count], face, labels[i]);
    for (std::size_t i = 0; i < count; ++i)
        link1(first + static_cast<Dart>(2 * i + 1),
              first + static_cast<Dart>(2 * ((i + 1) % count)));
    return first;
}

template<typename Visit> void LeafMap::visit_cell(Dart d, unsigned maps, Visit const& visit) const
{
    std::vector<Dart> pending { d };
    while (!pending.empty()) {
        auto const x = pending.back();
        pending.pop_back();
        if (!visit(x))
            continue;
        if (maps & kA0)
            pending.push_back(a0(x));
        if (maps & kA1)
            pending.push_back(a1(x));
        if (maps & kA2)
            pending.push_back(a2(x));
    }
}

// Merges the vertices of d and e into one, which is placed at their midpoint.
void LeafMap::merge(Dart d, Dart e)
{
    auto const kept = vertex(d);
    auto const lost = vertex(e);
    if (kept == lost)
        return;
    positions_[index(kept)] = 0.5 * (position(kept) + position(lost));
    flat_[index(kept)] = 0.5 * (flat(kept) + flat(lost));
    visit_cell(e, kA1 | kA2,
               [&](Dart x) { return std::exchange(vertex_[index(x)], kept) != kept; });
}

void LeafMap::sew(Dart d, Dart e)
{
    CHECK(is_free(d) && is_free(e) && e != d && e != a0(d));
    merge(d, e);
    merge(a0(d), a0(e));
    sew_in_place(d, e);
}

void LeafMap::sew_in_place(Dart d, Dart e)
{
    link2(d, e);
    link2(a0(d), a0(e));
}

void LeafMap::unsew(Dart d)
{
    for (auto const x : { d, a0(d) }) {
        auto const y = a2(x);
        a2_[index(x)] = x;
        a2_[index(y)] = y;
    }
}

// Divides an edge of one face at the vertex `middle`. The two darts of the edge, d and a0(d), keep
// the part at d, and two new darts take the rest. Returns the new dart at the middle.
Dart LeafMap::halve(Dart d, Vertex middle)
{
    auto const far = a0(d);
    auto const far_vertex = vertex(far);
    auto const after = a1(far);
    auto const pair = starts(d) ? add_edge(middle, far_vertex, face(d), label(d))
                                : add_edge(far_vertex, middle, face(d), label(d));
    auto const at_middle = starts(d) ? pair : a0(pair);
    vertex_[index(far)] = middle;
    link1(a0(at_middle), after);
    link1(far, at_middle);
    return at_middle;
}

Dart LeafMap::insert_vertex(Dart d, double share)
{
    auto const middle = add_vertex(position_of(d) + share * (position_of(a0(d)) - position_of(d)),
                                   flat_of(d) + share * (flat_of(a0(d)) - flat_of(d)));
    auto const other = a2(d);
    bool const is_sewn = !is_free(d);
    auto const rest = halve(d, middle);
    if (is_sewn) {
        auto const other_rest = halve(other, middle);
        link2(a0(d), a0(other));
        link2(rest, other_rest);
        link2(a0(rest), a0(other_rest));
    }
    return a0(d);
}

Dart LeafMap::insert_edge(Dart e1, Dart e2, FaceId far, EdgeLabel near_label, EdgeLabel far_label)
{
    auto const after_e1 = a1(e1);
    auto const after_e2 = a1(e2);
    auto const near_edge = add_edge(vertex(e1), vertex(e2), face(e1), near_label);
    auto const far_edge = add_edge(vertex(e2), vertex(e1), far, far_label);
    link2(near_edge, a0(far_edge));
    link2(a0(near_edge), far_edge);
    link1(e1, near_edge);
    link1(a0(near_edge), after_e2);
    link1(e2, far_edge);
    link1(a0(far_edge), after_e1);
    for (auto const d : cycle(far_edge)) {
        face_[index(d)] = far;
        face_[index(a0(d))] = far;
    }
    return far_edge;
}

void LeafMap::truncate(std::size_t dart_count)
{
    for (auto i = dart_count; i < a1_.size(); ++i)
        if (auto const other = a2_[i]; index(other) < dart_count)
            a2_[index(other)] = other;
    a1_.resize(dart_count);
    a2_.resize(dart_count);
    vertex_.resize(dart_count);
    face_.resize(dart_count);
    label_.resize(dart_count);
}

std::vector<Dart> LeafMap::cycle(Dart d) const
{
    auto const first = starts(d) ? d : a0(d);
    std::vector<Dart> darts;
    auto x = first;
    do {
        darts.push_back(x);
        x = a1(a0(x));
    } while (x != first);
    return darts;
}

Dart LeafMap::next_on_border(Dart d) const
{
    auto x = a1(a0(d));
    while (!is_free(x))
        x = a1(a2(x));
    return x;
}

std::vector<Dart> LeafMap::border(Dart d) const
{
    std::vector<Dart> darts;
    auto x = d;
    do {
        darts.push_back(x);
        x = next_on_border(x);
    } while (x != d);
    return darts;
}

std::size_t LeafMap::count_cells(unsigned maps) const
{
    std::vector<bool> seen(dart_count());
    std::size_t cells = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i])
            continue;
        ++cells;
        visit_cell(static_cast<Dart>(i), maps, [&](Dart d) {
            bool const is_new = !seen[index(d)];
            seen[index(d)] = true;
            return is_new;
        });
    }
    return cells;
}

MapCounts LeafMap::counts() const
{
    MapCounts counts { .faces = count_cells(kA0 | kA1),
                       .edges = count_cells(kA0 | kA2),
                       .vertices = count_cells(kA1 | kA2),
                       .darts = dart_count(),
                       .components = count_cells(kA0 | kA1 | kA2) };
    counts.triangles = dart_count() / 2 - 2 * counts.faces;
    std::vector<bool> seen(dart_count());
    for (Dart d = 0; index(d) < dart_count(); d += 2) {
        if (!is_free(d) || seen[index(d)])
            continue;
        ++counts.border_cycles;
        for (auto const x : border(d)) {
            seen[index(x)] = true;
            ++counts.border_edges;
        }
    }
    return counts;
}

// True if a1 and a2 link each dart that starts an edge to a dart that ends one, and vice versa.
bool LeafMap::is_oriented() const
{
    for (Dart d = 0; index(d) < dart_count(); ++d)
        if (starts(a1(d)) == starts(d) || (!is_free(d) && starts(a2(d)) == starts(d)))
            return false;
    return true;
}

std::string LeafMap::fault() const
{
    for (Dart d = 0; index(d) < dart_count(); ++d) {
        if (a1(a1(d)) != d || a2(a2(d)) != d)
            return "a map is not its own inverse";
        if (a1(d) == d)
            return "a face is open";
        if (a2(a0(a2(a0(d)))) != d)
            return "two edges are joined by half";
        if (vertex(d) != vertex(a1(d)) || vertex(d) != vertex(a2(d)))
            return "a vertex is in two places";
        if (vertex(d) == vertex(a0(d)))
            return "an edge ends where it starts";
        if (face(d) != face(a0(d)) || face(d) != face(a1(d)))
            return "a face has two names";
    }
    return is_oriented() ? "" : "it cannot be oriented";
}

} // namespace tractus::leaf
