#include "engine/methods/silhouettes/loops.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

// A crossing of two edges; edge i of an outline goes from point i to the next one.
struct Crossing {
    std::size_t first = 0;
    std::size_t second = 0;
};

std::optional<Crossing> find_crossing(std::span<Vec2 const> outline)
{
    auto const n = outline.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
        auto const& a = outline[i];
        auto const& b = outline[i + 1];
        Vec2 const low = a.cwiseMin(b);
        Vec2 const high = a.cwiseMax(b);
        for (std::size_t j = i + 2; j < (i == 0 ? n - 1 : n); ++j) {
            auto const& c = outline[j];
            auto const& d = outline[(j + 1) % n];
            bool const apart = std::max(c.x(), d.x()) < low.x() || std::min(c.x(), d.x()) > high.x()
                || std::max(c.y(), d.y()) < low.y() || std::min(c.y(), d.y()) > high.y();
            if (!apart && do_cross(a, b, c, d))
                return Crossing { i, j };
        }
    }
    return std::nullopt;
}

// Position of the intersection of the lines a-b and c-d, as a share of the way from a to b.
double share_to(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    return cross(c - a, d - c) / cross(b - a, d - c);
}

std::ptrdiff_t offset(std::size_t i)
{
    return static_cast<std::ptrdiff_t>(i);
}

} // namespace

bool crosses_itself(std::span<Vec2 const> outline)
{
    return find_crossing(outline).has_value();
}

LargestLoop largest_loop(std::vector<Vec2> const& outline)
{
    // Maximum number of cuts: a scribble's crossings can be as many as the square of its edges.
    constexpr std::size_t kMaxCuts = 20'000;
    std::vector<std::vector<Vec2>> waiting { outline };
    LargestLoop best;
    for (std::size_t cuts = 0; !waiting.empty() && cuts < kMaxCuts; ++cuts) {
        auto const loop = std::move(waiting.back());
        waiting.pop_back();
        auto const at = loop.size() < 3 ? std::nullopt : find_crossing(loop);
        if (!at) {
            double const area = loop.size() < 3 ? 0 : std::fabs(signed_area(loop));
            best.area_of_all += area;
            if (area > best.area) {
                best.area = area;
                best.outline = loop;
            }
            continue;
        }
        auto const& a = loop[at->first];
        auto const& b = loop[at->first + 1];
        double const share = share_to(a, b, loop[at->second], loop[(at->second + 1) % loop.size()]);
        Vec2 const corner = a + share * (b - a);
        std::vector<Vec2> inner { corner };
        inner.insert(inner.end(), loop.begin() + offset(at->first + 1),
                     loop.begin() + offset(at->second + 1));
        std::vector<Vec2> outer(loop.begin(), loop.begin() + offset(at->first + 1));
        outer.push_back(corner);
        outer.insert(outer.end(), loop.begin() + offset(at->second + 1), loop.end());
        waiting.push_back(std::move(inner));
        waiting.push_back(std::move(outer));
    }
    return best;
}

std::vector<Vec2> without_overshoot(std::vector<Vec2> const& stroke)
{
    auto const n = stroke.size();
    auto const quarter = std::max<std::size_t>(2, n / 4);
    for (std::size_t i = 0; i < quarter && i + 1 < n; ++i)
        for (std::size_t j = n - 2; j + 1 + quarter > n && j > i + 1; --j) {
            auto const& a = stroke[i];
            auto const& b = stroke[i + 1];
            auto const& c = stroke[j];
            auto const& d = stroke[j + 1];
            if (cross(b - a, d - c) == 0)
                continue;
            double const t = share_to(a, b, c, d);
            double const s = share_to(c, d, a, b);
            if (t < 0 || t > 1 || s < 0 || s > 1)
                continue;
            std::vector<Vec2> kept { a + t * (b - a) };
            kept.insert(kept.end(), stroke.begin() + offset(i + 1), stroke.begin() + offset(j + 1));
            return kept;
        }
    return stroke;
}

} // namespace tractus::silhouette
