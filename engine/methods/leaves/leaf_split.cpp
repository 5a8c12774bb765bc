// This file splits faces and glues edges.
#include "engine/methods/leaves/leaf.h"

#include <algorithm>
#include <cmath>

namespace tractus::leaf {

// Returns the label for the edge that a split adds to its near part: E for O, O for E, otherwise
// that of the side half-way around the face. No value if the face cannot be split in this way,
// because it has fewer than four sides or no opposite side.
std::optional<EdgeLabel> Leaf::opposite(FaceId face, EdgeLabel label) const
{
    std::vector<EdgeLabel> sides;
    for (auto const d : map_.cycle(faces_[static_cast<std::size_t>(face)].first))
        if (sides.empty() || sides.back() != map_.label(d))
            sides.push_back(map_.label(d));
    if (sides.size() > 1 && sides.front() == sides.back())
        sides.pop_back();
    auto const found = std::ranges::find(sides, label);
    if (sides.size() < 4 || found == sides.end())
        return std::nullopt;
    if (label == EdgeLabel::Origin)
        return EdgeLabel::Extremity;
    if (label == EdgeLabel::Extremity)
        return EdgeLabel::Origin;
    if (sides.size() % 2 == 1)
        return std::nullopt;
    auto const at = static_cast<std::size_t>(found - sides.begin());
    return sides[(at + sides.size() / 2) % sides.size()];
}

// Returns the dart that ends the first half of a side; the side is a chain of edges. A vertex near
// the middle is used if there is one, so that neighbouring faces that are split alike share it;
// otherwise a vertex is inserted.
Dart Leaf::end_of_first_half(std::vector<Dart> const& chain)
{
    // Maximum distance of an existing vertex from the middle, as a share of the side's length.
    constexpr double kNear = 0.05;
    std::vector<double> lengths;
    double whole = 0;
    for (auto const d : chain) {
        lengths.push_back((map_.position_of(LeafMap::a0(d)) - map_.position_of(d)).norm());
        whole += lengths.back();
    }
    double const half = whole / 2;
    double done = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        auto const d = chain[i];
        if (std::abs(done + lengths[i] - half) <= kNear * whole && i + 1 < chain.size())
            return LeafMap::a0(d);
        if (done + lengths[i] > half) {
            // Start dart of this edge in the neighbouring face.
            auto const start = LeafMap::a0(map_.a2(d));
            bool const is_sewn = !map_.is_free(d);
            auto const end = map_.insert_vertex(d, (half - done) / lengths[i]);
            auto& other = faces_[static_cast<std::size_t>(map_.face(start))];
            // The neighbouring face's first edge must keep its start.
            if (is_sewn && other.first == start)
                other.first = LeafMap::a0(map_.a1(start));
            return end;
        }
        done += lengths[i];
    }
    return LeafMap::a0(chain.front());
}

// Splits a face: the two sides next to the edge that the rule names are each cut in half, and a new
// edge joins the cuts. Returns false if the face cannot be split.
Result<bool> Leaf::split(Splitting const& splitting, FaceId face, TextPlace const& place)
{
    auto const near_label = opposite(face, splitting.edge);
    if (!near_label)
        return false;
    if (faces_.size() >= kMaxFaces)
        return fail_at(place, "the leaf would have too many faces");
    auto ring = map_.cycle(faces_[static_cast<std::size_t>(face)].first);
    TRY(spend(ring.size()));
    auto const label_of = [&](Dart d) { return map_.label(d); };
    std::rotate(ring.begin(), std::ranges::find(ring, splitting.edge, label_of), ring.end());
    auto const own = std::ranges::count(ring, splitting.edge, label_of);
    std::vector<Dart> const others(ring.begin() + own, ring.end());
    auto const last_of_next = std::ranges::find_if(
        others, [&](Dart d) { return label_of(d) != label_of(others.front()); });
    std::vector<Dart> const next(others.begin(), last_of_next);
    auto const before_previous = std::find_if(others.rbegin(), others.rend(), [&](Dart d) {
        return label_of(d) != label_of(others.back());
    });
    std::vector<Dart> const previous(before_previous.base(), others.end());
    if (next == previous)
        return false;
    auto const next_cut = end_of_first_half(next);
    auto const previous_cut = end_of_first_half(previous);
    auto const far = static_cast<FaceId>(faces_.size());
    auto const far_first
        = map_.insert_edge(next_cut, previous_cut, far, *near_label, splitting.edge);
    auto& near = faces_[static_cast<std::size_t>(face)];
    auto const frame = near.frame;
    auto const order = near.order;
    auto const blade = near.blade;
    near = { .name = splitting.near,
             .attributes = grammar_->faces.at(splitting.near),
             .frame = frame,
             .first = ring.front(),
             .edge_count = near.edge_count,
             .is_part = true,
             .order = order,
             .blade = blade };
    faces_.push_back({ .name = splitting.far,
                       .attributes = grammar_->faces.at(splitting.far),
                       .frame = frame,
                       .first = far_first,
                       .is_part = true,
                       .order = order,
                       .blade = blade });
    return true;
}

// Returns the dart at which walks along the border begin: the start of the axiom's edge O or, if a
// face has grown there, of the border edge that was created first.
Dart Leaf::border_start() const
{
    for (auto const d : map_.cycle(faces_.front().first))
        if (map_.label(d) == EdgeLabel::Origin && map_.is_free(d))
            return d;
    Dart d = 0;
    while (!map_.is_free(d))
        d += 2;
    return d;
}

// Glues one pair of consecutive border edges: the first pair that matches the rule, from
// border_start() on. Returns false if there is none.
bool Leaf::glue_one(Gluing const& gluing)
{
    auto const border = map_.border(border_start());
    if (border.size() < 4)
        return false;
    auto const face_edge = [&](Dart d) {
        return FaceEdge { faces_[static_cast<std::size_t>(map_.face(d))].name, map_.label(d) };
    };
    for (std::size_t i = 0; i < border.size(); ++i) {
        auto const d = border[i];
        auto const e = border[(i + 1) % border.size()];
        auto const first = face_edge(d);
        auto const second = face_edge(e);
        bool const is_wanted = (first == gluing.first && second == gluing.second)
            || (second == gluing.first && first == gluing.second);
        if (!is_wanted || map_.face(d) == map_.face(e))
            continue;
        map_.sew(LeafMap::a0(d), e);
        return true;
    }
    return false;
}

// Applies all gluing rules in turn, repeatedly, until none of them matches.
Result<void> Leaf::glue()
{
    for (bool is_any = true; std::exchange(is_any, false);)
        for (auto const& rule : grammar_->rules)
            if (auto const* const gluing = std::get_if<Gluing>(&rule.kind)) {
                TRY(spend(map_.dart_count()));
                is_any |= glue_one(*gluing);
            }
    return {};
}

} // namespace tractus::leaf
