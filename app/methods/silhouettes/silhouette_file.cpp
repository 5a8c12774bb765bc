#include "app/methods/silhouettes/silhouette_file.h"

#include "app/svg/svg_sketch.h"
#include "engine/base/file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace tractus::silhouette {

namespace {

using nlohmann::json;

constexpr std::string_view kExample = "write [[x, y], [x, y], …] in millimetres";
constexpr std::string_view kExampleInSpace = "write [[x, y, z], [x, y, z], …] in millimetres";

// True for keys of the file that the reader uses or that are reserved for other programs. All other
// keys are unknown.
bool is_known(std::string const& key)
{
    constexpr std::array kKeys { "outline", "trunk",  "branches", "parts",     "leaves", "splits",
                                 "joins",   "styles", "rings",    "climbs",    "sides",  "what",
                                 "unit",    "closed", "expected", "tolerance", "name" };
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

Result<std::vector<Vec2>> read_stroke(json const& list, std::string const& name)
{
    std::vector<Vec2> points;
    if (!list.is_array())
        return fail(Fault::User, fmt::format("{} is no line: {}", name, kExample));
    for (auto const& point : list) {
        if (!point.is_array() || point.size() != 2 || !point[0].is_number()
            || !point[1].is_number())
            return fail(
                Fault::User,
                fmt::format("point {} of {} is no point: {}", points.size() + 1, name, kExample));
        points.emplace_back(point[0].get<double>(), point[1].get<double>());
    }
    return points;
}

Result<CrownLine> read_line_in_space(json const& list, std::string const& name)
{
    CrownLine line;
    if (!list.is_array())
        return fail(Fault::User, fmt::format("{} is no line in space: {}", name, kExampleInSpace));
    for (auto const& point : list) {
        bool const is_point = point.is_array() && point.size() == 3 && point[0].is_number()
            && point[1].is_number() && point[2].is_number();
        if (!is_point)
            return fail(Fault::User,
                        fmt::format("point {} of {} is no point in space: {}", line.size() + 1,
                                    name, kExampleInSpace));
        line.emplace_back(point[0].get<double>(), point[1].get<double>(), point[2].get<double>());
    }
    return line;
}

// True if a list has strokes as its elements rather than points.
bool holds_strokes(json const& list)
{
    return list.is_array() && !list.empty() && list[0].is_array() && !list[0].empty()
        && list[0][0].is_array();
}

constexpr std::size_t kMaxStrokes = 100;

// Reads the list of strokes with the key `key`; empty if the key is missing.
Result<std::vector<std::vector<Vec2>>> read_strokes(json const& file, char const* key,
                                                    char const* one)
{
    std::vector<std::vector<Vec2>> strokes;
    if (!file.contains(key))
        return strokes;
    for (auto const& stroke : file[key]) {
        if (strokes.size() == kMaxStrokes)
            return fail(Fault::User,
                        fmt::format("there are more than {} {}: give fewer", kMaxStrokes, key));
        strokes.push_back(TRY(read_stroke(stroke, fmt::format("{} {}", one, strokes.size() + 1))));
    }
    return strokes;
}

// Reads the places of touches with the key `key`, if the file has it.
Result<void> read_touches(json const& file, char const* key, BumpTouch::Kind kind,
                          SilhouetteFile& result)
{
    if (!file.contains(key))
        return {};
    auto const places = TRY(read_stroke(file[key], key));
    if (places.size() > kMaxStrokes)
        return fail(Fault::User,
                    fmt::format("there are more than {} {}: give fewer", kMaxStrokes, key));
    for (auto const& place : places)
        result.touches.push_back({ kind, place });
    return {};
}

// A line together with a number, such as {"height": 20, "ring": [[x, z], …]}.
struct NumberedLine {
    double number = 0;
    std::vector<Vec2> line;
};
Result<std::vector<NumberedLine>> read_numbered(json const& file, char const* key,
                                                char const* number, char const* line)
{
    std::vector<NumberedLine> result;
    if (!file.contains(key))
        return result;
    for (auto const& entry : file[key]) {
        auto const name = fmt::format("{} {}", line, result.size() + 1);
        if (result.size() == kMaxStrokes)
            return fail(Fault::User,
                        fmt::format("there are more than {} {}: give fewer", kMaxStrokes, key));
        if (!entry.is_object() || !entry.contains(number) || !entry[number].is_number()
            || !entry.contains(line))
            return fail(Fault::User,
                        fmt::format("entry {} of {} is none: write {{\"{}\": 20, \"{}\": [[x, y], "
                                    "…]}}",
                                    result.size() + 1, key, number, line));
        result.push_back({ entry[number].get<double>(), TRY(read_stroke(entry[line], name)) });
    }
    return result;
}

// Reads the lines in space. The trunk must have been read before, because "sides" are turned about
// its base.
Result<void> read_crown_lines(json const& file, SilhouetteFile& result)
{
    for (auto const& [height, ring] : TRY(read_numbered(file, "rings", "height", "ring"))) {
        auto& line = result.crown_lines.emplace_back();
        for (auto const& point : ring)
            line.emplace_back(point.x(), height, point.y());
    }
    if (file.contains("climbs"))
        for (auto const& climb : file["climbs"])
            result.crown_lines.push_back(TRY(
                read_line_in_space(climb, fmt::format("climb {}", result.crown_lines.size() + 1))));
    auto const& trunk = result.drawing.trunk;
    double const foot = trunk.empty() ? 0 : trunk.front().x();
    for (auto const& [azimuth_deg, side] :
         TRY(read_numbered(file, "sides", "azimuth", "outline"))) {
        auto& line = result.crown_lines.emplace_back();
        double const angle = radians(azimuth_deg);
        for (auto const& point : side) {
            double const out = point.x() - foot;
            line.emplace_back(foot + out * std::cos(angle), point.y(), out * std::sin(angle));
        }
    }
    if (result.crown_lines.size() > kMaxStrokes)
        return fail(Fault::User,
                    fmt::format("there are more than {} lines in space: give fewer", kMaxStrokes));
    return {};
}

// If there is no outline, makes the first leaf's outline the crown.
void settle_crown(SilhouetteFile& file)
{
    if (!file.drawing.outline.empty() || file.leaves.empty())
        return;
    file.drawing.outline.push_back(std::move(file.leaves.front()));
    file.drawing.is_leaf = true;
    file.leaves.erase(file.leaves.begin());
}

Result<void> read_outline(json const& outline, SilhouetteFile& result)
{
    if (holds_strokes(outline)) {
        if (outline.size() > kMaxStrokes)
            return fail(Fault::User,
                        fmt::format("outline has {} strokes: give at most {}", outline.size(),
                                    kMaxStrokes));
        for (auto const& stroke : outline)
            result.drawing.outline.push_back(TRY(read_stroke(
                stroke, fmt::format("stroke {} of outline", result.drawing.outline.size() + 1))));
    } else {
        result.drawing.outline.push_back(TRY(read_stroke(outline, "outline")));
    }
    return {};
}

Result<SilhouetteFile> read_drawing(json const& file)
{
    constexpr std::array kCrowns { "outline", "leaves", "rings", "climbs", "sides" };
    bool const has_crown = file.is_object()
        && std::any_of(kCrowns.begin(), kCrowns.end(),
                       [&](char const* key) { return file.contains(key); });
    if (!has_crown)
        return fail(Fault::User,
                    "it is no drawing: write {\"outline\": [[x, y], …], \"trunk\": [[x, y], …]}");
    SilhouetteFile result;
    if (file.contains("outline"))
        TRY(read_outline(file["outline"], result));
    result.leaves = TRY(read_strokes(file, "leaves", "leaf"));
    settle_crown(result);
    TRY(read_touches(file, "splits", BumpTouch::Kind::Split, result));
    TRY(read_touches(file, "joins", BumpTouch::Kind::Join, result));
    result.drawing.branches = TRY(read_strokes(file, "branches", "branch"));
    result.parts = TRY(read_strokes(file, "parts", "part"));
    result.styles = TRY(read_strokes(file, "styles", "style"));
    if (file.contains("trunk") && !file["trunk"].is_null())
        result.drawing.trunk = TRY(read_stroke(file["trunk"], "trunk"));
    TRY(read_crown_lines(file, result));
    for (auto const& [key, value] : file.items())
        if (!is_known(key))
            result.unknown_keys.push_back(key);
    return result;
}

// Adds the file's name to the beginning of an error's message.
Result<SilhouetteFile> named(Result<SilhouetteFile> result, std::string const& name)
{
    if (!result)
        return fail(result.error().fault, fmt::format("{}: {}", name, result.error().message));
    return result;
}

// Distance between a line's two ends, as a share of the line's length.
double straightness(std::vector<Vec2> const& line)
{
    double const length = length_of(line);
    return length > 0 ? (line.back() - line.front()).norm() / length : 0;
}

Result<SilhouetteFile> read_svg(std::string_view text)
{
    auto lines = TRY(svg::read_svg_lines(
        text, { "trunk", "outline", "branch", "part", "leaf", "split", "join", "style" }));
    SilhouetteFile result;
    bool const said = std::any_of(lines.begin(), lines.end(),
                                  [](auto const& line) { return !line.role.empty(); });
    if (!said) {
        auto const trunk
            = std::max_element(lines.begin(), lines.end(), [](auto const& a, auto const& b) {
                  return straightness(a.points_mm) < straightness(b.points_mm);
              });
        for (auto line = lines.begin(); line != lines.end(); ++line)
            line->role = "outline";
        if (straightness(trunk->points_mm) > 0.5)
            trunk->role = "trunk";
    }
    std::vector<BumpTouch> splits;
    std::vector<BumpTouch> joins;
    for (auto& line : lines) {
        if (line.role == "trunk")
            result.drawing.trunk = std::move(line.points_mm);
        else if (line.role == "outline")
            result.drawing.outline.push_back(std::move(line.points_mm));
        else if (line.role == "branch")
            result.drawing.branches.push_back(std::move(line.points_mm));
        else if (line.role == "part")
            result.parts.push_back(std::move(line.points_mm));
        else if (line.role == "leaf")
            result.leaves.push_back(std::move(line.points_mm));
        else if (line.role == "split")
            splits.push_back({ BumpTouch::Kind::Split, resampled_line(line.points_mm, 3)[1] });
        else if (line.role == "join")
            joins.push_back({ BumpTouch::Kind::Join, resampled_line(line.points_mm, 3)[1] });
        else if (line.role == "style")
            result.styles.push_back(std::move(line.points_mm));
    }
    result.touches = std::move(splits);
    result.touches.insert(result.touches.end(), joins.begin(), joins.end());
    settle_crown(result);
    return result;
}

Result<SilhouetteFile> read_json(std::string_view text)
{
    try {
        return read_drawing(json::parse(text));
    } catch (json::exception const&) {
        return fail(Fault::User,
                    "this is no JSON: a bracket, comma or quotation mark is missing or too many");
    }
}

} // namespace

Result<SilhouetteFile> parse_silhouette(std::string_view text, std::string const& name)
{
    return named(read_json(text), name);
}

Result<SilhouetteFile> load_silhouette(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxBytes = std::size_t { 2 } << 20;
    auto const text = TRY(read_text_file(path, kMaxBytes));
    if (path.extension() == ".svg")
        return named(read_svg(text), path.string());
    return parse_silhouette(text, path.string());
}

} // namespace tractus::silhouette
