#include "engine/methods/construction_lines/line_edits.h"

#include <algorithm>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

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
    case Role::Unsure:
        break;
    }
    return "unsure";
}

bool has(LineSketch const& sketch, Role role)
{
    return !(role == Role::Left ? sketch.left : sketch.right).empty();
}

// What a plant needs most that has none of it; empty where nothing is missing.
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
        if (!has(sketch, side))
            return fmt::format("{} is the other one, mirrored, until you draw it",
                               what_it_is(side));
    return "";
}

// Why nobody knows what the newest line is: asked again, since no sketch keeps it.
std::string reason_of(PenSketch sketch)
{
    auto const line = sketch.lines.back();
    sketch.lines.pop_back();
    LineRecogniser recogniser;
    for (auto const& known : sketch.lines)
        if (auto const points = points_on_sheet(known))
            recogniser.add_known(*points, known.role);
    auto const points = points_on_sheet(line);
    return points ? recogniser.add(*points).reason : "";
}

} // namespace

std::string said_of(PenSketch const& sketch)
{
    if (sketch.lines.empty())
        return "";
    auto const role = sketch.lines.back().role;
    if (role == Role::Unsure)
        return fmt::format("It has no effect: {}", reason_of(sketch));
    auto const lines = line_sketch(sketch);
    auto const missing = lines ? what_is_missing(*lines) : "";
    return fmt::format("This is {}{}{}", what_it_is(role), missing.empty() ? "" : ": ", missing);
}

} // namespace tractus::lines
