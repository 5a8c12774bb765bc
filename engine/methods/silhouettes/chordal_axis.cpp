#include "engine/methods/silhouettes/chordal_axis.h"

#include <algorithm>
#include <utility>

namespace tractus::silhouette {

ChordalAxis::ChordalAxis(std::vector<Vec2> outline)
    : outline_(std::move(outline))
    , triangles_(triangulate(outline_))
{
}

int ChordalAxis::chord_count(std::uint32_t triangle) const
{
    auto const& beyond = triangles_[triangle].beyond;
    return static_cast<int>(std::count_if(beyond.begin(), beyond.end(),
                                          [](auto other) { return other != kNoTriangle; }));
}

ChordalAxis::Counts ChordalAxis::counts() const
{
    Counts counts;
    for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
        auto const chords = chord_count(k);
        counts.terminal += chords == 1;
        counts.sleeve += chords == 2;
        counts.junction += chords == 3;
    }
    return counts;
}

Arc ChordalAxis::beyond(Chord const& chord) const
{
    // The triangle is on the left of the edge from corner e to the next one. The outline beyond the
    // chord therefore runs from the first corner to the second on its right.
    auto const& corner = triangles_[chord.triangle].corner;
    return { corner[chord.edge], corner[(chord.edge + 1) % 3] };
}

Chord ChordalAxis::reversed(Chord const& chord) const
{
    auto const other = triangles_[chord.triangle].beyond[chord.edge];
    auto const corner = triangles_[chord.triangle].corner[(chord.edge + 1) % 3];
    std::uint32_t edge = 0;
    while (edge < 2 && triangles_[other].corner[edge] != corner)
        ++edge;
    return { other, edge };
}

std::vector<Chord> ChordalAxis::onward(Chord const& chord) const
{
    auto const back = reversed(chord);
    std::vector<Chord> others;
    for (std::uint32_t e = 0; e < 3; ++e)
        if (e != back.edge && triangles_[back.triangle].beyond[e] != kNoTriangle)
            others.push_back({ back.triangle, e });
    return others;
}

Circle circumcircle(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    Vec2 const u = b - a;
    Vec2 const v = c - a;
    Vec2 const way = Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                          u.x() * v.squaredNorm() - v.x() * u.squaredNorm())
        / (2 * cross(u, v));
    return { a + way, way.norm() };
}

double ChordalAxis::rise(Chord const& chord) const
{
    auto const& corner = triangles_[chord.triangle].corner;
    auto const circle = circumcircle(outline_[corner[0]], outline_[corner[1]], outline_[corner[2]]);
    auto const arc = beyond(chord);
    double farthest = 0;
    for (auto i = (arc.first + 1) % outline_.size(); i != arc.last; i = (i + 1) % outline_.size())
        farthest = std::max(farthest, (outline_[i] - circle.center).squaredNorm());
    return std::sqrt(farthest) - circle.radius;
}

} // namespace tractus::silhouette
