#include "engine/methods/silhouettes/triangulation.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace tractus::silhouette {

namespace {

using Corners = std::vector<std::uint32_t>;

// Clips ears off an outline until one triangle is left.
class EarCutter {
public:
    explicit EarCutter(std::span<Vec2 const> outline)
        : outline_(outline)
        , ring_(outline.size())
    {
        std::iota(ring_.begin(), ring_.end(), 0U);
    }

    std::vector<std::array<std::uint32_t, 3>> cut()
    {
        std::vector<std::array<std::uint32_t, 3>> ears;
        std::size_t from = 0;
        while (ring_.size() > 3) {
            auto const at = find_ear(from);
            ears.push_back(corners_at(at));
            ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
            from = at; // Continues at the next corner, so that the ears are not all at one corner.
        }
        ears.push_back({ ring_[0], ring_[1], ring_[2] });
        return ears;
    }

private:
    std::array<std::uint32_t, 3> corners_at(std::size_t i) const
    {
        auto const n = ring_.size();
        return { ring_[(i + n - 1) % n], ring_[i % n], ring_[(i + 1) % n] };
    }

    double turn_at(std::size_t i) const
    {
        auto const c = corners_at(i);
        return cross(outline_[c[1]] - outline_[c[0]], outline_[c[2]] - outline_[c[1]]);
    }

    // True if a triangle contains no other corner of the remaining outline.
    bool is_empty(std::array<std::uint32_t, 3> const& c) const
    {
        auto const& p = outline_[c[0]];
        auto const& q = outline_[c[1]];
        auto const& r = outline_[c[2]];
        Vec2 const low = p.cwiseMin(q).cwiseMin(r);
        Vec2 const high = p.cwiseMax(q).cwiseMax(r);
        return std::none_of(ring_.begin(), ring_.end(), [&](std::uint32_t v) {
            auto const& x = outline_[v];
            return v != c[0] && v != c[1] && v != c[2] && x.x() >= low.x() && x.x() <= high.x()
                && x.y() >= low.y() && x.y() <= high.y() && cross(q - p, x - p) >= 0
                && cross(r - q, x - q) >= 0 && cross(p - r, x - r) >= 0;
        });
    }

    std::size_t find_ear(std::size_t from) const
    {
        auto const n = ring_.size();
        for (std::size_t k = 0; k < n; ++k) {
            auto const i = (from + k) % n;
            if (turn_at(i) > 0 && is_empty(corners_at(i)))
                return i;
        }
        // There is no ear, because only collinear corners are left: clips the one with the largest
        // turn.
        std::size_t best = 0;
        for (std::size_t i = 1; i < n; ++i)
            if (turn_at(i) > turn_at(best))
                best = i;
        return best;
    }

    std::span<Vec2 const> outline_;
    Corners ring_;
};

// Index of the triangle's edge that starts at this corner.
int edge_from(Triangle const& triangle, std::uint32_t corner)
{
    int const edge = triangle.corner[0] == corner ? 0 : triangle.corner[1] == corner ? 1 : 2;
    CHECK(triangle.corner[static_cast<std::size_t>(edge)] == corner);
    return edge;
}

std::size_t next_of(std::size_t edge)
{
    return (edge + 1) % 3;
}

std::vector<Triangle> with_neighbours(std::vector<std::array<std::uint32_t, 3>> const& ears)
{
    std::vector<Triangle> triangles(ears.size());
    struct Edge {
        std::uint64_t key = 0;
        std::uint32_t triangle = 0;
        std::uint32_t edge = 0;
    };
    std::vector<Edge> edges;
    for (std::uint32_t k = 0; k < ears.size(); ++k) {
        triangles[k] = { ears[k], { kNoTriangle, kNoTriangle, kNoTriangle } };
        for (std::uint32_t e = 0; e < 3; ++e) {
            auto const a = ears[k][e];
            auto const b = ears[k][next_of(e)];
            edges.push_back({ std::uint64_t { std::min(a, b) } << 32U | std::max(a, b), k, e });
        }
    }
    std::sort(edges.begin(), edges.end(), [](Edge const& a, Edge const& b) {
        return std::pair(a.key, a.triangle) < std::pair(b.key, b.triangle);
    });
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i].key == edges[i - 1].key) {
            triangles[edges[i].triangle].beyond[edges[i].edge] = edges[i - 1].triangle;
            triangles[edges[i - 1].triangle].beyond[edges[i - 1].edge] = edges[i].triangle;
        }
    return triangles;
}

class Flipper {
public:
    Flipper(std::span<Vec2 const> outline, std::vector<Triangle>& triangles)
        : outline_(outline)
        , triangles_(triangles)
    {
        auto const box = box_of(outline);
        double const size = (box.high - box.low).maxCoeff();
        margin_ = 1e-12 * size * size * size * size;
    }

    void run()
    {
        for (std::uint32_t k = 0; k < triangles_.size(); ++k)
            for (std::size_t e = 0; e < 3; ++e)
                add(k, e);
        while (!waiting_.empty()) {
            auto const [triangle, from] = waiting_.back();
            waiting_.pop_back();
            visit(triangle, from);
        }
    }

private:
    void add(std::uint32_t triangle, std::size_t edge)
    {
        if (triangles_[triangle].beyond[edge] != kNoTriangle)
            waiting_.emplace_back(triangle, triangles_[triangle].corner[edge]);
    }

    Vec2 const& place(std::uint32_t corner) const { return outline_[corner]; }

    void visit(std::uint32_t k, std::uint32_t from)
    {
        auto& one = triangles_[k];
        if (std::find(one.corner.begin(), one.corner.end(), from) == one.corner.end())
            return; // The edge no longer exists; it was flipped.
        auto const e = static_cast<std::size_t>(edge_from(one, from));
        auto const l = one.beyond[e];
        if (l == kNoTriangle)
            return;
        auto& other = triangles_[l];
        auto const b = one.corner[next_of(e)];
        auto const f = static_cast<std::size_t>(edge_from(other, b));
        auto const c = one.corner[next_of(next_of(e))];
        auto const d = other.corner[next_of(next_of(f))];
        // The margin prevents endless flipping of cocircular corners.
        if (in_circle(place(from), place(b), place(c), place(d)) <= margin_)
            return;
        flip({ k, l, e, f });
    }

    struct Pair {
        std::uint32_t k = 0; // Index of the triangle (a, b, c) on one side of an edge from a to b.
        std::uint32_t l = 0; // Index of the triangle (b, a, d) on the other side.
        std::size_t e = 0;   // Edge of triangle k that starts at a.
        std::size_t f = 0;   // Edge of triangle l that starts at b.
    };

    // Replaces the edge from a to b, which two triangles share, by the edge from d to c.
    void flip(Pair const& pair)
    {
        auto& one = triangles_[pair.k];
        auto& other = triangles_[pair.l];
        auto const e1 = next_of(pair.e);
        auto const e2 = next_of(e1);
        auto const f1 = next_of(pair.f);
        auto const f2 = next_of(f1);
        auto const a = one.corner[pair.e];
        auto const b = one.corner[e1];
        auto const c = one.corner[e2];
        auto const d = other.corner[f2];
        auto const over_bc = one.beyond[e1];
        auto const over_ca = one.beyond[e2];
        auto const over_ad = other.beyond[f1];
        auto const over_db = other.beyond[f2];
        one = { { a, d, c }, { over_ad, pair.l, over_ca } };
        other = { { d, b, c }, { over_db, over_bc, pair.k } };
        reconnect(over_ad, pair.l, pair.k);
        reconnect(over_bc, pair.k, pair.l);
        for (std::size_t edge = 0; edge < 3; ++edge) {
            add(pair.k, edge);
            add(pair.l, edge);
        }
    }

    void reconnect(std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
    {
        if (triangle == kNoTriangle)
            return;
        auto& beyond = triangles_[triangle].beyond;
        std::replace(beyond.begin(), beyond.end(), from, to);
    }

    std::span<Vec2 const> outline_;
    std::vector<Triangle>& triangles_;
    double margin_ = 0;
    // Edges still to be checked: a triangle, and the corner at which the edge starts.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting_;
};

} // namespace

double in_circle(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    Vec2 const p = a - d;
    Vec2 const q = b - d;
    Vec2 const r = c - d;
    return p.squaredNorm() * cross(q, r) + q.squaredNorm() * cross(r, p)
        + r.squaredNorm() * cross(p, q);
}

std::vector<Triangle> triangulate(std::span<Vec2 const> outline)
{
    CHECK(outline.size() >= 3);
    auto triangles = with_neighbours(EarCutter(outline).cut());
    Flipper(outline, triangles).run();
    return triangles;
}

} // namespace tractus::silhouette
