#include "app/methods/leaves/leaf_sketch_file.h"

#include "app/svg/svg_sketch.h"
#include "engine/base/file.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tractus::leaf {

namespace {

using nlohmann::json;

constexpr std::string_view kStrokes
    = "write {\"strokes\": [[[x, y], [x, y], …], …]} in millimetres";

Result<Vec3> read_leaf_point(json const& value, std::size_t stroke, std::size_t point)
{
    bool const is_point = value.is_array() && (value.size() == 2 || value.size() == 3)
        && std::ranges::all_of(value, [](json const& part) { return part.is_number(); });
    if (!is_point)
        return fail(Fault::User,
                    fmt::format("point {} of stroke {} is no point: {}", point, stroke, kStrokes));
    return Vec3(value[0].get<double>(), value[1].get<double>(),
                value.size() == 3 ? value[2].get<double>() : 0);
}

Result<leaf::LeafDrawing> read_leaf_strokes(json const& file)
{
    if (!file.is_object() || !file.contains("strokes") || !file["strokes"].is_array())
        return fail(Fault::User, fmt::format("it is no drawing of a leaf: {}", kStrokes));
    leaf::LeafDrawing drawing;
    for (auto const& stroke : file["strokes"]) {
        auto const number = drawing.strokes.size() + 1;
        if (!stroke.is_array())
            return fail(Fault::User, fmt::format("stroke {} is no line: {}", number, kStrokes));
        auto& points = drawing.strokes.emplace_back();
        for (auto const& point : stroke)
            points.push_back(TRY(read_leaf_point(point, number, points.size() + 1)));
    }
    return drawing;
}

Result<leaf::LeafDrawing> read_leaf_json(std::string_view text)
{
    try {
        return read_leaf_strokes(json::parse(text));
    } catch (json::exception const&) {
        return fail(Fault::User,
                    "this is no JSON: a bracket, comma or quotation mark is missing or too many");
    }
}

Result<leaf::LeafDrawing> read_leaf_svg(std::string_view text)
{
    leaf::LeafDrawing drawing;
    for (auto const& line : TRY(svg::read_svg_lines(text, {}))) {
        auto& points = drawing.strokes.emplace_back();
        for (auto const& point : line.points_mm)
            points.emplace_back(point.x(), point.y(), 0);
    }
    return drawing;
}

// Adds the file's name to the beginning of an error's message.
Result<leaf::LeafDrawing> in_file(Result<leaf::LeafDrawing> result, std::string const& name)
{
    if (!result)
        return fail(result.error().fault, fmt::format("{}: {}", name, result.error().message));
    return result;
}

} // namespace

Result<leaf::LeafDrawing> parse_leaf_sketch(std::string_view text, std::string const& name)
{
    return in_file(read_leaf_json(text), name);
}

Result<leaf::LeafDrawing> load_leaf_sketch(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxBytes = std::size_t { 8 } << 20;
    auto const text = TRY(read_text_file(path, kMaxBytes));
    if (path.extension() == ".svg")
        return in_file(read_leaf_svg(text), path.string());
    return parse_leaf_sketch(text, path.string());
}

} // namespace tractus::leaf
