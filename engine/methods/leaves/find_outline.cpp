#include "engine/methods/leaves/find_outline.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr char const* kDrawOutline
    = "there is no outline: draw the leaf's edge as one closed line, as two halves from base to "
      "tip, or as one half beside its midrib";

double extent_of_all(std::span<FlatLine const> strokes)
{
    FlatLine all;
    for (auto const& stroke : strokes)
        all.insert(all.end(), stroke.begin(), stroke.end());
    return extent_of(all);
}

bool is_closed(FlatLine const& line, double extent)
{
    // Largest gap between the ends of a closed line, as a share of the line's extent.
    constexpr double kMaxGap = 0.12;
    // Smallest area of an outline, as a share of the square of the drawing's extent.
    constexpr double kMinArea = 0.008;
    double const gap = (line.back() - line.front()).norm();
    return gap < kMaxGap * extent_of(line) && std::abs(area_of(line)) > kMinArea * extent * extent;
}

// Index of a closed line's last point if its end overshoots the beginning: the point of the end
// piece that is nearest to the beginning.
std::size_t end_without_overshoot(FlatLine const& line)
{
    double const length = length_of(line);
    double const step = length / double(line.size() - 1);
    auto const most = static_cast<std::size_t>(std::min(6.0, 0.1 * length) / step);
    std::size_t best = line.size() - 1;
    for (std::size_t i = line.size() - 1; i + most >= line.size(); --i)
        if ((line[i] - line[0]).norm() < (line[best] - line[0]).norm())
            best = i;
    return best;
}

// Two lines that enclose an area together.
struct Loop {
    std::size_t first = 0;
    // Index of the other line, which may extend beyond the loop, as a midrib with its stalk does.
    std::size_t second = 0;
    double area = 0;
    bool ends_meet = false;
};

// Returns the part of a line from the point nearest to `from` to the point nearest to `to`.
FlatLine part_between(FlatLine const& line, Vec2 const& from, Vec2 const& to)
{
    double const a = nearest_on(line, from).along;
    double const b = nearest_on(line, to).along;
    FlatLine part { place_at(line, a) };
    for (std::size_t i = 0; i < line.size(); ++i) {
        auto const j = a < b ? i : line.size() - 1 - i;
        if (double(j) > std::min(a, b) && double(j) < std::max(a, b))
            part.push_back(line[j]);
    }
    part.push_back(place_at(line, b));
    return part;
}

std::optional<Loop> loop_of(std::span<FlatLine const> strokes, std::size_t i, std::size_t j,
                            double tolerance)
{
    auto const& a = strokes[i];
    auto const& b = strokes[j];
    if (nearest_on(b, a.front()).distance > tolerance
        || nearest_on(b, a.back()).distance > tolerance)
        return std::nullopt;
    auto const meets = [&](Vec2 const& p, Vec2 const& q) { return (p - q).norm() <= tolerance; };
    auto ring = part_between(b, a.back(), a.front());
    if (length_of(ring) < 0.5 * (a.back() - a.front()).norm())
        return std::nullopt;
    ring.insert(ring.begin(), a.begin(), a.end());
    return Loop { .first = i,
                  .second = j,
                  .area = std::abs(area_of(ring)),
                  .ends_meet = (meets(a.front(), b.front()) && meets(a.back(), b.back()))
                      || (meets(a.front(), b.back()) && meets(a.back(), b.front())) };
}

// Signed area between a line and its chord, positive to the left of the chord, as a share of the
// square of the chord's length.
double bow_of(FlatLine const& line)
{
    return area_of(line) / (line.back() - line.front()).squaredNorm();
}

// Finds the two strokes that together enclose the largest area.
std::optional<Loop> widest_loop(std::span<FlatLine const> strokes, double extent)
{
    double const tolerance = std::max(4.0, 0.05 * extent);
    std::optional<Loop> best;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        for (std::size_t j = 0; j < strokes.size(); ++j)
            if (i != j)
                if (auto const loop = loop_of(strokes, i, j, tolerance);
                    loop && (!best || loop->area > best->area))
                    best = loop;
    constexpr double kMinArea = 0.004;
    if (best && best->area < kMinArea * extent * extent)
        return std::nullopt;
    return best;
}

// True if two lines are halves of an outline: both bow clearly, to opposite sides of their common
// chord. A midrib, in contrast, is nearly straight.
bool are_halves(FlatLine const& a, FlatLine const& b)
{
    constexpr double kMin = 0.25; // Smallest bow, as a share of the other line's bow.
    double const bow_a = bow_of(a);
    bool const is_opposite = (a.front() - b.front()).norm() > (a.front() - b.back()).norm();
    double const bow_b = is_opposite ? -bow_of(b) : bow_of(b);
    return bow_a * bow_b < 0
        && std::min(std::abs(bow_a), std::abs(bow_b))
        > kMin * std::max(std::abs(bow_a), std::abs(bow_b));
}

void add_points(FoundOutline& outline, std::size_t stroke, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        outline.line.push_back({ stroke, i });
}

Result<FoundOutline> outline_of_loop(std::span<FlatLine const> strokes, Loop const& loop)
{
    auto const& a = strokes[loop.first];
    auto const& b = strokes[loop.second];
    FoundOutline made;
    if (loop.ends_meet && are_halves(a, b)) {
        made.edge = RecognisedLeaf::Edge::Halves;
        made.strokes = { loop.first, loop.second };
        add_points(made, loop.first, a.size());
        auto const size = made.line.size();
        add_points(made, loop.second, b.size());
        if ((a.back() - b.front()).norm() > (a.back() - b.back()).norm())
            std::reverse(made.line.begin() + static_cast<std::ptrdiff_t>(size), made.line.end());
        return made;
    }
    bool const first_is_rib = std::abs(bow_of(a)) < std::abs(bow_of(b));
    auto const half = first_is_rib ? loop.second : loop.first;
    made.edge = RecognisedLeaf::Edge::OneHalf;
    made.strokes = { half };
    made.midrib = first_is_rib ? loop.first : loop.second;
    add_points(made, half, strokes[half].size());
    return made;
}

} // namespace

Result<FoundOutline> find_outline(std::span<FlatLine const> strokes)
{
    double const extent = extent_of_all(strokes);
    std::vector<std::pair<double, std::size_t>> closed; // Area and index of each closed stroke.
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (is_closed(strokes[i], extent))
            closed.emplace_back(std::abs(area_of(strokes[i])), i);
    std::ranges::sort(closed, std::greater {});
    // Smallest area of a stroke that counts as a second blade, as a share of the largest blade's
    // area.
    constexpr double kMinBlade = 0.2;
    if (closed.size() > 1 && closed[1].first > kMinBlade * closed[0].first)
        return fail(Fault::User,
                    fmt::format("strokes {} and {} are both closed: draw one blade by itself, "
                                "since only simple leaves can be drawn by pen so far",
                                std::min(closed[0].second, closed[1].second) + 1,
                                std::max(closed[0].second, closed[1].second) + 1));
    if (!closed.empty()) {
        FoundOutline made;
        made.strokes = { closed[0].second };
        add_points(made, closed[0].second, end_without_overshoot(strokes[closed[0].second]) + 1);
        return made;
    }
    auto const loop = widest_loop(strokes, extent);
    if (!loop)
        return fail(Fault::User, kDrawOutline);
    return outline_of_loop(strokes, *loop);
}

} // namespace tractus::leaf
