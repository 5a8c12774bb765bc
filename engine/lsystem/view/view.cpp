#include "engine/lsystem/view/view.h"

#include "engine/lsystem/text/user_text.h"
#include "engine/lsystem/view/view_files.h"
#include "engine/lsystem/view/view_organs.h"
#include "engine/lsystem/view/view_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <string>
#include <vector>

namespace tractus::lsystem {

namespace {

constexpr double kUnitsPerPixel = 0.05;

// Reads the line width. Widths in pixels, which are meant for lines on a screen, are converted,
// since a plant needs some thickness. As in cpfg, the last statement of the line width or the line
// style decides the unit of all widths.
Result<void> read_line_width(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.empty())
        return reader.error("found nothing, expected the line width");
    auto const width = TRY(reader.number(parts[0]));
    bool const is_pixels = parts.size() > 1 && parts[1].substr(0, 1) == "p";
    reader.view.line_width = std::max(0.0, width);
    reader.view.width_unit = is_pixels ? kUnitsPerPixel : 1;
    return {};
}

// Reads the line style: pixel, polygon or cylinder, or its number. All styles are drawn as
// cylinders.
Result<void> read_line_style(ViewReader& reader, std::string_view value)
{
    bool const is_pixels = value.substr(0, 5) == "pixel" || value.substr(0, 1) == "1";
    reader.view.width_unit = is_pixels ? kUnitsPerPixel : 1;
    return {};
}

Result<void> read_tropism_direction(ViewReader& reader, std::string_view value)
{
    auto const direction = TRY(reader.vector(value));
    if (!(direction.norm() > 0))
        return reader.error("the tropism direction must not be zero");
    reader.view.tropism_direction = direction.normalized();
    return {};
}

// Reads T: x y z [A: angle] [I: intensity] [E: elasticity] [S: step]. As in cpfg, separators are
// blanks, commas and colons.
Result<void> read_movement(ViewReader& reader, std::string_view value, bool is_torque)
{
    auto const parts = words(value, " \t,:");
    Tropism tropism;
    tropism.is_torque = is_torque;
    double intensity = 1;
    for (std::size_t i = 0; i < parts.size();) {
        auto const letter = parts[i++][0];
        std::size_t const count = letter == 'T' ? 3 : 1;
        if (i + count > parts.size())
            return reader.error(
                fmt::format("found {} at the line's end, expected its value", letter));
        Vec3 numbers = Vec3::Zero();
        for (std::size_t k = 0; k < count; ++k)
            numbers[static_cast<int>(k)] = TRY(reader.number(parts[i + k]));
        i += count;
        if (letter == 'T')
            tropism.direction = numbers;
        else if (letter == 'A')
            tropism.angle_deg = numbers[0];
        else if (letter == 'I' || letter == 'i')
            intensity = std::clamp(numbers[0], -1.0, 1.0);
        else if (letter == 'E' || letter == 'a')
            tropism.elasticity = numbers[0];
        else if (letter == 'S')
            tropism.elasticity_step = numbers[0];
        else
            return reader.error(fmt::format("found {}, expected T, A, I, E or S", letter));
    }
    if (!(tropism.direction.norm() > 0))
        return reader.error("the tropism direction must not be zero");
    tropism.direction = tropism.direction.normalized() * intensity;
    reader.view.tropisms.push_back(tropism);
    return {};
}

Result<void> read_tropism(ViewReader& reader, std::string_view value)
{
    return read_movement(reader, value, false);
}

Result<void> read_torque(ViewReader& reader, std::string_view value)
{
    return read_movement(reader, value, true);
}

// Reads the first number of a statement whose other numbers only concern the display. If there is
// none, warns and returns no value, since cpfg skips such a statement, too.
std::optional<double> first_number(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value, " \t,");
    auto const first = parts.empty() ? std::nullopt : number(parts[0]);
    if (!first)
        reader.warn(fmt::format("found '{}', expected a number; the statement is skipped", value));
    return first;
}

template<double View::*Target> Result<void> read_scalar(ViewReader& reader, std::string_view value)
{
    if (auto const read = first_number(reader, value))
        reader.view.*Target = *read;
    return {};
}

template<int View::*Target, int Min, int Max>
Result<void> read_integer(ViewReader& reader, std::string_view value)
{
    if (auto const read = first_number(reader, value))
        reader.view.*Target = static_cast<int>(std::clamp<double>(*read, Min, Max));
    return {};
}

template<bool View::*Target> Result<void> read_switch(ViewReader& reader, std::string_view value)
{
    if (value.substr(0, 2) == "on")
        reader.view.*Target = true;
    else if (value.substr(0, 3) == "off")
        reader.view.*Target = false;
    else
        reader.warn(fmt::format("found '{}', expected on or off; the statement is skipped", value));
    return {};
}

Result<void> read_tapered_lines(ViewReader& reader, std::string_view value)
{
    if (value.substr(0, 3) == "off")
        reader.warn("lines are always tapered: a segment's width passes into the next one's");
    return {};
}

Result<void> read_angle_factor(ViewReader& reader, std::string_view value)
{
    auto const read = first_number(reader, value);
    if (read && *read != 0)
        reader.view.angle_increment_deg = 360 / *read;
    return {};
}

// Reads a scale. As in cpfg, a scale of 0 is ignored.
template<double View::*Target> Result<void> read_scale(ViewReader& reader, std::string_view value)
{
    auto const read = first_number(reader, value);
    if (read && *read != 0)
        reader.view.*Target = std::clamp(*read, -1e6, 1e6);
    return {};
}

// Reads LEVEL, by which older views set the number of sides to 2^(LEVEL + 1).
Result<void> read_polygonization_level(ViewReader& reader, std::string_view value)
{
    if (auto const level = first_number(reader, value))
        reader.view.contour_sides = std::clamp(
            static_cast<int>(std::lround(std::exp2(std::clamp(*level, 0.0, 10.0) + 1))), 3, 256);
    return {};
}

Result<void> read_environment(ViewReader& reader, std::string_view text)
{
    if (!names_environment(text)) {
        reader.warn(fmt::format("the environment '{}' is not read: nothing is run that a model "
                                "names; there are light, space, terrain and water",
                                shown(text)));
        return {};
    }
    auto choice = parse_environment(text);
    if (!choice)
        return reader.error(choice.error().message);
    reader.view.environment = *std::move(choice);
    return {};
}

struct Statement {
    std::string_view key;
    ReadStatement read;
};

constexpr std::array kStatements {
    Statement { "angle factor", read_angle_factor },
    Statement { "angle increment", read_scalar<&View::angle_increment_deg> },
    Statement { "initial color", read_integer<&View::color, 0, 255> },
    Statement { "color increment", read_integer<&View::color_step, -255, 255> },
    Statement { "initial line width", read_line_width },
    Statement { "line style", read_line_style },
    Statement { "line width increment", read_scalar<&View::line_width_step> },
    Statement { "tapered lines", read_tapered_lines },
    Statement { "initial scale", read_scale<&View::scale> },
    Statement { "scale multiplier", read_scale<&View::scale_step> },
    Statement { "interpretation past %", read_switch<&View::draws_past_cut> },
    Statement { "tropism direction", read_tropism_direction },
    Statement { "initial elasticity", read_scalar<&View::elasticity> },
    Statement { "elasticity increment", read_scalar<&View::elasticity_step> },
    Statement { "tropism", read_tropism },
    Statement { "torque", read_torque },
    Statement { "function", read_function },
    Statement { "function set", read_function_set },
    Statement { "curve", read_curve },
    Statement { "contour", read_contour },
    Statement { "contour sides", read_integer<&View::contour_sides, 3, 256> },
    Statement { "polygonization level", read_polygonization_level },
    Statement { "twist of cylinders", read_switch<&View::twist_of_cylinders> },
    Statement { "surface", read_surface },
    Statement { "line", read_surface }, // As in cpfg, the statement `line:` also defines a surface.
    Statement { "tsurface", read_triangle_surface },
    Statement { "color", read_color },
    Statement { "material", read_material },
    Statement { "organ", read_organ },
    Statement { "leaf", read_leaf },
    Statement { "calendar", read_calendar },
    Statement { "radii", read_radii },
    Statement { "environment", read_environment },
};

// Statements that only concern cpfg's display; they are ignored.
constexpr std::array<std::string_view, 34> kDisplayKeys { "viewpoint",
                                                          "view reference point",
                                                          "twist",
                                                          "projection",
                                                          "front distance",
                                                          "back distance",
                                                          "scale factor",
                                                          "z buffer",
                                                          "cue range",
                                                          "shade mode",
                                                          "light direction",
                                                          "diffuse reflection",
                                                          "surface ambient",
                                                          "surface diffuse",
                                                          "box",
                                                          "background color",
                                                          "ambient light",
                                                          "font",
                                                          "light",
                                                          "render mode",
                                                          "viewing angle",
                                                          "background scene",
                                                          "interpretation step",
                                                          "rayshade objects",
                                                          "rayshade scale",
                                                          "environment display",
                                                          "antialiasing",
                                                          "min zoom",
                                                          "max zoom",
                                                          "generate on view change",
                                                          "winfont",
                                                          "concave polygons",
                                                          "shadow map",
                                                          "PS linecap" };

// A statement that would affect the drawing but is not supported, and what happens instead.
struct MissingStatement {
    std::string_view key;
    std::string_view instead;
};

constexpr std::array kMissingStatements {
    MissingStatement { "texture", "surfaces have the colours of their materials" },
    MissingStatement { "blob", "inblob() is 0" },
};

// Returns a suggestion to end a message about an unknown key with; empty if no key is similar.
std::string meant_key(std::string_view key)
{
    std::vector<std::string_view> keys(kDisplayKeys.begin(), kDisplayKeys.end());
    for (auto const& statement : kStatements)
        keys.push_back(statement.key);
    for (auto const& statement : kMissingStatements)
        keys.push_back(statement.key);
    auto const nearest = nearest_beginning(key, keys);
    return nearest.empty() ? std::string() : fmt::format("; '{}:', perhaps", nearest);
}

Result<void> read_statement(ViewReader& reader, std::string_view key, std::string_view value)
{
    auto const has_key = [&](auto const& entry) { return entry.key == key; };
    auto const* const known = std::find_if(kStatements.begin(), kStatements.end(), has_key);
    if (known != kStatements.end())
        return known->read(reader, value);
    if (std::find(kDisplayKeys.begin(), kDisplayKeys.end(), key) != kDisplayKeys.end())
        return {};
    auto const* const missing
        = std::find_if(kMissingStatements.begin(), kMissingStatements.end(), has_key);
    if (missing == kMissingStatements.end())
        reader.warn(fmt::format("found '{}: {}', which is no statement of a view{}", shown(key),
                                shown(value), meant_key(key)));
    else if (reader.missing.insert(missing->key).second) // Warns only once for each key.
        reader.warn(fmt::format("'{}:' is not supported; {}", key, missing->instead));
    return {};
}

} // namespace

Result<View> parse_view(std::string const& name, std::string_view text,
                        IncludeReader const& include)
{
    auto const source = TRY(preprocess(name, text, include));
    ViewReader reader { source, include };
    reader.view.warnings = source.warnings;
    std::string_view const all = source.text;
    for (std::size_t begin = 0; begin < all.size();) {
        auto const end = std::min(all.find('\n', begin), all.size());
        auto const line = trimmed(all.substr(begin, end - begin));
        reader.at = all.find_first_not_of(" \t", begin);
        begin = end + 1;
        if (line.empty())
            continue;
        auto const colon = line.find(':');
        if (colon == std::string_view::npos) {
            reader.warn(fmt::format("found '{}', expected 'key: value'; the line is skipped{}",
                                    shown(line), meant_key(line)));
            continue;
        }
        TRY(read_statement(reader, trimmed(line.substr(0, colon)),
                           trimmed(line.substr(colon + 1))));
    }
    return std::move(reader.view);
}

} // namespace tractus::lsystem
