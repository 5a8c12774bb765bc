#include "engine/methods/construction_lines/lines_to_draw.h"

#include "engine/methods/construction_lines/drawn_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::lines {

namespace {

using Line = std::vector<Vec2>;

constexpr std::array kSides { 1.0, -1.0 }; // Signs of the left and the right side of the stem.

// Returns a curve beside the stem, from its foot to its top, that is farthest from it in the
// middle.
Line bow_beside(DrawnLine const& stem, double side)
{
    constexpr int kPieces = 16;
    // Largest distance of the curve from the stem, as a share of the stem's length.
    constexpr double kWidest = 0.25;
    Line bow;
    for (int i = 0; i <= kPieces; ++i) {
        double const x = static_cast<double>(i) / kPieces;
        double const at_mm = x * stem.length_mm();
        double const out_mm = kWidest * stem.length_mm() * std::sin(kPi * x);
        bow.push_back(stem.point(at_mm) + side * out_mm * direction(stem.heading_deg(at_mm) + 90));
    }
    return bow;
}

// Returns an inclination line across the stem. It is straight from the stem to the boundary on each
// side; a boundary may be missing.
Line across(DrawnLine const& stem, std::array<Line, 2> const& boundaries,
            Inclination const& inclination)
{
    // Length of half an inclination line that meets no boundary, as a share of the stem's length.
    constexpr double kElse = 0.2;
    double const at_mm = inclination.x * stem.length_mm();
    Vec2 const foot = stem.point(at_mm);
    std::array const angles_deg { inclination.left_deg, inclination.right_deg };
    std::array<Vec2, 2> ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        Vec2 const way = direction(stem.heading_deg(at_mm) + kSides[i] * angles_deg[i]);
        auto const reach_mm = DrawnLine(boundaries[i]).nearest_hit_mm(foot, way);
        ends[i] = foot + reach_mm.value_or(kElse * stem.length_mm()) * way;
    }
    return { ends[0], foot, ends[1] };
}

// Default inclination lines to suggest: both or, if one inclination line was drawn, the one at the
// stem's other end.
std::vector<Inclination> inclinations_to_draw(LineSketch const& sketch, DrawnLine const& stem)
{
    auto const measured = measure_sketch(sketch, Missing::Guessed);
    if (!measured || sketch.inclinations.size() > 1)
        return {};
    auto guessed = measured->inclinations;
    if (sketch.inclinations.empty())
        return guessed;
    auto const drawn = crossings(stem, DrawnLine(without_repeats(sketch.inclinations.front())));
    bool const is_low = !drawn.empty() && drawn.front().first_mm < stem.length_mm() / 2;
    return { is_low ? guessed.back() : guessed.front() };
}

} // namespace

std::vector<std::vector<Vec2>> lines_to_draw(LineSketch const& sketch)
{
    if (!measure_sketch(sketch, Missing::Guessed))
        return {};
    Line seen;
    for (auto const& point : sketch.stem)
        seen.push_back(point.head<2>());
    DrawnLine const stem(without_repeats(seen));
    if (!has_boundary(sketch))
        return { bow_beside(stem, kSides[0]), bow_beside(stem, kSides[1]) };
    std::vector<Line> lines;
    std::array boundaries { without_repeats(sketch.left), without_repeats(sketch.right) };
    // A sketch with boundaries in space may be complete, so nothing is suggested.
    if (!sketch.around.empty())
        return lines;
    for (std::size_t i = 0; i < boundaries.size(); ++i)
        if (boundaries[i].empty())
            lines.push_back(boundaries[i] = without_repeats(mirrored(stem, boundaries[1 - i])));
    for (auto const& inclination : inclinations_to_draw(sketch, stem))
        lines.push_back(across(stem, boundaries, inclination));
    return lines;
}

} // namespace tractus::lines
