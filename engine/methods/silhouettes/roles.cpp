#include "engine/methods/silhouettes/bumps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

// Largest angle to the trunk's final direction at which a bump counts as straight ahead.
constexpr double kAhead_deg = 20;
// The trunk forks and has no apex if the second-best bump's closeness() is less than this multiple
// of the best one's.
constexpr double kFork = 1.25;
// Length of the trunk's extension if there is no bump ahead, as a share of the distance to the
// outline.
constexpr double kOn = 0.85;

// The bump through whose arc the trunk enters the outline, if the trunk passes the bump's end at
// less than `reach` times the bump's radius.
std::optional<std::size_t> find_foot(std::vector<Bump> const& bumps, std::span<Vec2 const> outline,
                                     std::span<Vec2 const> trunk, std::size_t first_inside,
                                     double reach)
{
    if (first_inside == 0)
        return std::nullopt;
    auto const n = outline.size();
    for (std::size_t m = 0; m < bumps.size(); ++m)
        for (std::size_t i = bumps[m].arc.first; i != bumps[m].arc.last; i = (i + 1) % n) {
            if (!do_cross(trunk[first_inside - 1], trunk[first_inside], outline[i],
                          outline[(i + 1) % n]))
                continue;
            double least = bumps[m].radius;
            for (std::size_t k = 1; k < trunk.size(); ++k)
                least = std::min(least, distance_to_segment(bumps[m].end, trunk[k - 1], trunk[k]));
            return least < reach * bumps[m].radius ? std::optional(m) : std::nullopt;
        }
    return std::nullopt;
}

// Penalty for choosing a bump as the apex: below 1 if the bump surrounds the trunk's end or is
// straight ahead of the end.
double closeness(Bump const& bump, Vec2 const& end, Vec2 const& ahead)
{
    Vec2 const way = bump.end - end;
    double const cosine = way.dot(ahead) / std::max(way.norm(), 1e-30);
    double const off_deg = degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    return std::min(way.norm() / bump.radius, off_deg / kAhead_deg);
}

// True if an outline without junctions is about as wide as it is long, so that its longest
// direction is arbitrary.
bool is_round(std::vector<Bump> const& bumps, std::span<Vec2 const> outline)
{
    constexpr double kRound = 1.15;
    if (bumps.size() != 2 || bumps[0].strength > 0 || bumps[1].strength > 0)
        return false;
    Vec2 const along = direction_of(bumps[1].end - bumps[0].end);
    std::vector<Vec2> turned_points;
    for (auto const& point : outline)
        turned_points.emplace_back(point.dot(along), cross(along, point));
    Vec2 const size = box_of(turned_points).high - box_of(turned_points).low;
    return size.x() < kRound * size.y();
}

} // namespace

std::optional<Run> inside_run(std::span<Vec2 const> outline, std::span<Vec2 const> trunk)
{
    std::optional<Run> longest;
    std::size_t count = 0; // Number of consecutive samples inside the outline.
    for (std::size_t k = 0; k <= trunk.size(); ++k) {
        if (k < trunk.size() && is_inside(outline, trunk[k])) {
            ++count;
            continue;
        }
        if (count > 0 && (!longest || count - 1 > longest->last - longest->first))
            longest = Run { k - count, k - 1 };
        count = 0;
    }
    return longest;
}

std::optional<Vec2> set_roles(std::vector<Bump>& bumps, std::span<Vec2 const> outline,
                              std::span<Vec2 const> trunk, Run const& run, double foot_reach)
{
    for (auto& bump : bumps)
        bump.role = Role::Lateral;
    auto const foot = find_foot(bumps, outline, trunk, run.first, foot_reach);
    if (foot)
        bumps[*foot].role = Role::Foot;
    Vec2 const end = trunk[run.last];
    auto const eighth = trunk.size() / 8;
    auto const before = std::max(run.first, run.last > eighth ? run.last - eighth : 0);
    Vec2 const ahead = direction_of(end - trunk[before]);
    if (is_round(bumps, outline)) {
        bool const second = (bumps[1].end - bumps[0].end).dot(ahead) > 0;
        bumps[second ? 1 : 0].role = Role::Apex;
        bumps[second ? 0 : 1].role = Role::Foot;
        return std::nullopt;
    }
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t m = 0; m < bumps.size(); ++m)
        if (m != foot)
            near.emplace_back(closeness(bumps[m], end, ahead), m);
    std::sort(near.begin(), near.end());
    bool const forks
        = near.size() > 1 && near[0].first < 2 && near[1].first < kFork * near[0].first;
    if (!near.empty() && near[0].first < 1 && !forks) {
        bumps[near[0].second].role = Role::Apex;
        return std::nullopt;
    }
    if (run.last + 1 != trunk.size() || forks)
        return std::nullopt;
    auto const far = ray_distance_to_outline(outline, end, ahead);
    return far ? std::optional<Vec2>(end + kOn * *far * ahead) : std::nullopt;
}

} // namespace tractus::silhouette
