#include "engine/methods/construction_lines/line_edits.h"

#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/read_pen_sketch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

// Names the kind of a stem in a plant that may have several stems.
std::string what_stem_it_is(SketchLine const& line)
{
    if (line.parent)
        return "a stem that stands on another one";
    return line.stem == 0 ? "the stem" : "another stem";
}

std::string what_it_is(Role role)
{
    switch (role) {
    case Role::Stem:
        return "the stem";
    case Role::Left:
        return "the left boundary";
    case Role::Right:
        return "the right boundary";
    case Role::Inclination:
        return "an inclination line";
    case Role::HalfInclination:
        return "half an inclination line";
    case Role::Around:
        return "a boundary in space";
    case Role::Outline:
        return "the outline, which is both boundaries";
    case Role::Unsure:
        break;
    }
    return "unsure";
}

// Describes the side of the stem on which a boundary in space lies.
std::string side_of(PenSketch const& sketch, SketchLine const& line)
{
    auto const stems = stem_sketches(sketch);
    auto const points = points_on_sheet(line);
    if (!stems || !points)
        return "";
    auto const azimuth_deg = azimuth_of(*points, DrawnStem(stems->at(line.stem).sketch.stem));
    constexpr std::array kQuarters { "on the left", "behind", "on the right", "in front" };
    auto const quarter
        = static_cast<std::size_t>(std::lround(azimuth_deg.value_or(0) / 90)) % kQuarters.size();
    return fmt::format(", {}, {:.0f} degrees around the stem", kQuarters[quarter],
                       azimuth_deg.value_or(0));
}

bool has(LineSketch const& sketch, Role role)
{
    return !(role == Role::Left ? sketch.left : sketch.right).empty();
}

// Describes the line that the stem needs most; empty if none is missing.
std::string what_is_missing(LineSketch const& sketch)
{
    if (!has_boundary(sketch))
        return "draw a boundary on its left or right, the line that the leaves' tips reach, such "
               "as the dotted ones";
    if (sketch.inclinations.empty())
        return "draw inclination lines across the stem; until then leaves lean by 45 degrees";
    if (sketch.inclinations.size() == 1)
        return "draw a second inclination line; until then the first one holds all along the stem";
    for (auto const side : { Role::Left, Role::Right })
        if (!has(sketch, side) && sketch.around.empty())
            return fmt::format("{} is the other one, mirrored, until you draw it",
                               what_it_is(side));
    return "";
}

// Explains why the newest line was not recognised, by recognising it again: a sketch does not store
// the reason.
std::string reason_of(PenSketch sketch)
{
    auto const line = sketch.lines.back();
    sketch.lines.pop_back();
    StemRecogniser recogniser;
    for (auto const& known : sketch.lines)
        if (auto const points = points_on_sheet(known))
            recogniser.add_known(
                *points,
                { .line = { .role = known.role }, .stem = known.stem, .parent = known.parent });
    auto const points = points_on_sheet(line);
    return points ? recogniser.add(*points).line.reason : "";
}

// Describes the line that the newest line's stem needs most; empty if none is missing.
std::string what_is_missing(PenSketch const& sketch)
{
    auto const stem = current_stem(sketch);
    if (stem && *stem != sketch.lines.back().stem)
        return "what grows on the other one grows on it, too, until you draw a boundary beside it";
    auto const lines = line_sketch(sketch);
    return lines ? what_is_missing(*lines) : "";
}

// Describes how the newest line was interpreted together with all other lines.
std::string describe_reading(PenSketch const& sketch, PenReading const& reading)
{
    auto const& line = sketch.lines.back();
    auto const& stroke = reading.strokes.back();
    if (line.role == Role::Unsure)
        return fmt::format("It has no effect: {}", stroke.reason);
    auto const what = line.role == Role::Stem ? what_stem_it_is(line) : what_it_is(line.role);
    std::string text
        = stroke.of ? fmt::format("This is a part of {}", what) : fmt::format("This is {}", what);
    if (line.role == Role::Around)
        text += side_of(sketch, line);
    if (stroke.is_drawn_reversed)
        text += ", from its top to its foot, and is turned round: \"Turn round\" of What a line is "
                "turns it back";
    auto const missing = what_is_missing(sketch);
    if (!missing.empty())
        text += ": " + missing;
    auto const& second = reading.second_best_roles;
    if (!second.empty() && second.back() != line.role)
        text += fmt::format(" (it might be {})",
                            second.back() == Role::Unsure ? "nothing" : what_it_is(second.back()));
    return text;
}

} // namespace

std::string describe_result(PenSketch const& sketch)
{
    if (sketch.lines.empty())
        return "";
    auto const& line = sketch.lines.back();
    if (is_read_together(sketch))
        if (auto const reading = read_pen_sketch(sketch))
            return describe_reading(sketch, *reading);
    if (line.role == Role::Unsure)
        return fmt::format("It has no effect: {}", reason_of(sketch));
    auto const missing = what_is_missing(sketch);
    return fmt::format("This is {}{}{}{}",
                       line.role == Role::Stem ? what_stem_it_is(line) : what_it_is(line.role),
                       line.role == Role::Around ? side_of(sketch, line) : "",
                       missing.empty() ? "" : ": ", missing);
}

} // namespace tractus::lines
