#include "engine/methods/construction_lines/several_stems.h"

#include "engine/base/check.h"
#include "engine/methods/construction_lines/drawn_stem.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

namespace {

// A stem that begins within this distance of another one is attached to it.
constexpr double kOnStem_mm = 5;

std::optional<DrawnStem> drawn_stem(LineSketch const& sketch)
{
    auto const points = without_repeats(sketch.stem);
    if (points.size() < 2)
        return std::nullopt;
    return DrawnStem(points);
}

// Returns the position at which a stem with this foot is attached to its parent, as a share of the
// parent's length; 1 near the parent's top.
double foot_on(DrawnStem const& parent, Vec2 const& foot_mm)
{
    double const at_mm = parent.seen().nearest_mm(foot_mm);
    return parent.seen().length_mm() - at_mm < kOnStem_mm ? 1 : parent.place(at_mm);
}

// Moves the foot of a stem to a place. Points farther along the stem move less.
void move_foot(std::vector<Vec3>& stem, Vec3 const& to_mm)
{
    Vec3 const by_mm = to_mm - stem.front();
    double const length_mm = polyline_length_mm(stem);
    double at_mm = 0;
    Vec3 before_mm = stem.front();
    for (auto& point : stem) {
        at_mm += (point - before_mm).norm();
        before_mm = point;
        double const share = length_mm > 0 ? at_mm / length_mm : 0;
        // Depths are heights above the start of each stroke, so all points move by the same depth.
        point += Vec3((1 - share) * by_mm.x(), (1 - share) * by_mm.y(), by_mm.z());
    }
}

// Returns a stem with the inclination lines, nodes and organs of another stem.
Construction with_functions_of(Construction stem, Construction const& other)
{
    stem.inclinations = other.inclinations;
    stem.nodes_per_layer = other.nodes_per_layer;
    stem.nodes = other.nodes;
    stem.around = other.around;
    stem.organs_per_layer = other.organs_per_layer;
    stem.notes.clear();
    return stem;
}

Result<Construction> measure(StemLines const& stem, std::size_t number, bool is_alone,
                             Missing missing)
{
    if (is_alone)
        return measure_sketch(stem.sketch, missing);
    auto result = has_boundary(stem.sketch) ? measure_sketch(stem.sketch, missing)
                                            : measure_sketch({ .stem = stem.sketch.stem,
                                                               .left = {},
                                                               .right = {},
                                                               .inclinations = {},
                                                               .nodes_per_layer = {} },
                                                             Missing::Guessed);
    if (!result)
        return fail(result.error().fault,
                    fmt::format("stem {}: {}", number + 1, result.error().message));
    for (auto& note : result->notes)
        note = fmt::format("stem {}: {}", number + 1, note);
    return result;
}

Result<void> check_parents(std::vector<StemLines> const& stems)
{
    for (std::size_t i = 0; i < stems.size(); ++i)
        if (stems[i].parent && *stems[i].parent >= i)
            return fail(Fault::User,
                        fmt::format("stem {} cannot stand on stem {}, which comes after it: give "
                                    "the number of an earlier stem",
                                    i + 1, *stems[i].parent + 1));
    return {};
}

} // namespace

std::optional<std::size_t> parent_at(std::span<StemLines const> stems, Vec2 const& foot_mm)
{
    // A stem that begins this close to the foot of another stem is not attached to it.
    constexpr double kAtFoot_mm = 8;
    double nearest_mm = kOnStem_mm;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < stems.size(); ++i) {
        auto const stem = drawn_stem(stems[i].sketch);
        if (!stem)
            continue;
        double const at_mm = stem->seen().nearest_mm(foot_mm);
        double const away_mm = (stem->seen().point(at_mm) - foot_mm).norm();
        if (away_mm > nearest_mm)
            continue;
        if (at_mm < kAtFoot_mm)
            return stems[i].parent;
        nearest_mm = away_mm;
        found = i;
    }
    return found;
}

std::vector<std::size_t> function_sources(std::span<StemLines const> stems)
{
    auto const first = std::find_if(stems.begin(), stems.end(), [](StemLines const& stem) {
        return has_boundary(stem.sketch);
    });
    std::vector<std::size_t> sources;
    for (std::size_t i = 0; i < stems.size(); ++i) {
        auto const& stem = stems[i];
        if (has_boundary(stem.sketch) || first == stems.end())
            sources.push_back(i);
        else if (stem.parent)
            sources.push_back(sources[*stem.parent]);
        else
            sources.push_back(static_cast<std::size_t>(first - stems.begin()));
    }
    return sources;
}

Result<std::vector<MeasuredStem>> measure_stems(std::vector<StemLines> stems, Missing missing)
{
    CHECK(!stems.empty());
    TRY(check_parents(stems));
    auto const sources = function_sources(stems);
    std::vector<MeasuredStem> result;
    for (std::size_t i = 0; i < stems.size(); ++i) {
        auto& stem = stems[i];
        double foot_x = 0;
        if (stem.parent && !stem.sketch.stem.empty()) {
            auto const& parent = result[*stem.parent].construction.stem;
            foot_x = foot_on(parent, stem.sketch.stem.front().head<2>());
            double const depth_mm = stem.sketch.stem.front().z();
            move_foot(stem.sketch.stem, parent.point(foot_x));
            for (auto& line : stem.sketch.around)
                for (auto& point : line)
                    point.z() += stem.sketch.stem.front().z() - depth_mm;
        }
        result.push_back({ .construction = TRY(measure(stem, i, stems.size() == 1, missing)),
                           .parent = stem.parent,
                           .foot_x = foot_x,
                           .functions = sources[i] });
    }
    for (std::size_t i = 0; i < result.size(); ++i)
        if (sources[i] != i)
            result[i].construction = with_functions_of(std::move(result[i].construction),
                                                       result[sources[i]].construction);
    return result;
}

std::vector<std::string> notes_of(std::span<MeasuredStem const> stems)
{
    std::vector<std::string> notes;
    for (auto const& stem : stems)
        notes.insert(notes.end(), stem.construction.notes.begin(), stem.construction.notes.end());
    return notes;
}

bool has_boundary(std::span<StemLines const> stems)
{
    return std::any_of(stems.begin(), stems.end(),
                       [](StemLines const& stem) { return has_boundary(stem.sketch); });
}

} // namespace tractus::lines
