#include "app/methods/construction_lines/line_sketch_file.h"

#include "app/methods/construction_lines/read_json_lines.h"
#include "app/methods/construction_lines/read_json_organs.h"
#include "app/svg/svg_sketch.h"
#include "engine/base/file.h"
#include "engine/lsystem/view/view_texture.h"
#include "engine/methods/construction_lines/around_stem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace tractus::lines {

namespace {

using nlohmann::json;

constexpr std::array kStemKeys { "stem",       "left",         "right",
                                 "boundaries", "inclinations", "nodes_per_layer" };
constexpr std::array kOtherKeys { "pattern", "divergence", "face",    "sizes",
                                  "organs",  "organ",      "strokes", "stems" };
// Maximum number of strokes in a file, of stems, and of boundaries in space.
constexpr std::size_t kMaxStrokes = 100;

// Reads the boundary with the key `key`. The stem must have been read before. If the boundary is
// not flat, it is added to the sketch's boundaries in space, and the result is empty.
Result<std::vector<Vec2>> read_side(json const& file, char const* key, LineSketch& sketch)
{
    if (!has_value(file, key))
        return std::vector<Vec2>();
    auto line = TRY(read_line(file[key], key));
    if (depth_of(line, sketch.stem) <= kFlat)
        return read_flat_line(file[key], key);
    sketch.around.push_back(std::move(line));
    return std::vector<Vec2>();
}

Result<void> read_boundaries(json const& file, LineSketch& sketch)
{
    if (!has_value(file, "boundaries"))
        return {};
    auto const& lines = file["boundaries"];
    if (!lines.is_array() || lines.size() > kMaxStrokes)
        return fail(Fault::User,
                    fmt::format("boundaries is no list of at most {} lines: write [[[u, v, w], [u, "
                                "v, w]]]",
                                kMaxStrokes));
    int number = 0;
    for (auto const& line : lines)
        sketch.around.push_back(TRY(read_line(line, fmt::format("boundary {}", ++number))));
    return {};
}

Result<void> read_lines(json const& file, LineSketch& sketch)
{
    if (has_value(file, "stem"))
        sketch.stem = TRY(read_line(file["stem"], "stem"));
    sketch.left = TRY(read_side(file, "left", sketch));
    sketch.right = TRY(read_side(file, "right", sketch));
    TRY(read_boundaries(file, sketch));
    if (!has_value(file, "inclinations"))
        return {};
    auto const& lines = file["inclinations"];
    if (!lines.is_array())
        return fail(Fault::User,
                    "inclinations is no list of lines: write [[[u, v], [u, v]], "
                    "[[u, v], [u, v]]]");
    for (auto const& line : lines)
        sketch.inclinations.push_back(TRY(read_flat_line(
            line, fmt::format("inclination line {}", sketch.inclinations.size() + 1))));
    return {};
}

Result<std::vector<int>> read_nodes(json const& numbers, std::string const& name)
{
    if (!numbers.is_array())
        return fail(Fault::User, fmt::format("{} is no list: write numbers such as [5, 3]", name));
    std::vector<int> nodes;
    for (auto const& number : numbers) {
        double const count = number.is_number() ? number.get<double>() : std::nan("");
        if (!(std::fabs(count) <= 1e6) || count != std::floor(count))
            return fail(
                Fault::User,
                fmt::format(
                    "{} has {}: give whole numbers from 0 to {}", name,
                    number.dump(-1, ' ', true, json::error_handler_t::replace).substr(0, 40),
                    kMaxNodesInLayer));
        nodes.push_back(static_cast<int>(count));
    }
    return nodes;
}

// Reads a stroke that begins another stem, given as an object.
Result<void> read_stem_stroke(json const& stroke, LineSketchFile& result)
{
    auto const name = fmt::format("stroke {}", result.strokes.size() + 1);
    if (!has_value(stroke, "stem"))
        return fail(Fault::User,
                    fmt::format("{} is no line: write [[u, v], [u, v]], or {{\"stem\": [[u, v], "
                                "[u, v]]}} for another stem",
                                name));
    auto nodes = result.sketch.nodes_per_layer;
    if (has_value(stroke, "nodes_per_layer"))
        nodes = TRY(read_nodes(stroke["nodes_per_layer"], "nodes_per_layer of " + name));
    result.stem_strokes[result.strokes.size()] = std::move(nodes);
    result.strokes.push_back(TRY(read_line(stroke["stem"], name)));
    return {};
}

// Reads the strokes. The numbers of nodes must have been read before.
Result<void> read_strokes(json const& file, LineSketchFile& result)
{
    if (!has_value(file, "strokes"))
        return {};
    auto const& strokes = file["strokes"];
    if (!strokes.is_array() || strokes.size() > kMaxStrokes)
        return fail(Fault::User,
                    fmt::format("strokes is no list of at most {} lines: write [[[u, v], [u, v]], "
                                "[[u, v], [u, v]]], the stem first",
                                kMaxStrokes));
    for (auto const* const key : { "stem", "left", "right", "boundaries", "inclinations", "stems" })
        if (has_value(file, key))
            return fail(
                Fault::User,
                fmt::format("strokes are there and {0}, too: leave out {0}, or call each of "
                            "the strokes what it is",
                            key));
    for (auto const& stroke : strokes) {
        if (stroke.is_object()) {
            TRY(read_stem_stroke(stroke, result));
            continue;
        }
        result.strokes.push_back(
            TRY(read_line(stroke, fmt::format("stroke {}", result.strokes.size() + 1))));
    }
    return {};
}

// Reads the further stems. A stem without numbers of nodes has those of the first stem.
Result<void> read_stems(json const& file, LineSketchFile& result)
{
    if (!has_value(file, "stems"))
        return {};
    auto const& stems = file["stems"];
    if (!stems.is_array() || stems.size() >= kMaxStrokes)
        return fail(Fault::User,
                    fmt::format("stems is no list of fewer than {} stems: write [{{\"stem\": [[u, "
                                "v], [u, v]]}}]",
                                kMaxStrokes));
    for (auto const& stem : stems) {
        auto const name = fmt::format("stem {}", result.further_stems.size() + 2);
        if (!stem.is_object() || !has_value(stem, "stem"))
            return fail(Fault::User,
                        fmt::format("{} has no line: write {{\"stem\": [[u, v], [u, v]]}}", name));
        LineSketch sketch { .stem = {},
                            .left = {},
                            .right = {},
                            .inclinations = {},
                            .nodes_per_layer = result.sketch.nodes_per_layer };
        if (auto const lines = read_lines(stem, sketch); !lines)
            return fail(lines.error().fault, fmt::format("{}: {}", name, lines.error().message));
        if (has_value(stem, "nodes_per_layer"))
            sketch.nodes_per_layer
                = TRY(read_nodes(stem["nodes_per_layer"], "nodes_per_layer of " + name));
        result.further_stems.push_back(std::move(sketch));
    }
    return {};
}

Result<void> read_first_nodes(json const& file, LineSketch& sketch)
{
    if (!has_value(file, "nodes_per_layer") && has_value(file, "strokes"))
        return {}; // The list stays empty, so the layers get the line tool's default number.
    if (!has_value(file, "nodes_per_layer"))
        return fail(Fault::User,
                    "nodes_per_layer is missing: give the number of nodes of each layer "
                    "between two neighbouring inclination lines, such as [5], or --nodes 5");
    sketch.nodes_per_layer = TRY(read_nodes(file["nodes_per_layer"], "nodes_per_layer"));
    return {};
}

bool is_key_of_stem(std::string const& key)
{
    return std::find(kStemKeys.begin(), kStemKeys.end(), key) != kStemKeys.end();
}

std::vector<std::string> unknown_keys(json const& file)
{
    std::vector<std::string> result;
    for (auto const& [key, value] : file.items())
        if (!is_key_of_stem(key)
            && std::find(kOtherKeys.begin(), kOtherKeys.end(), key) == kOtherKeys.end())
            result.push_back(key);
    for (auto const* const list : { "stems", "strokes" }) {
        if (!has_value(file, list))
            continue;
        for (auto const& stem : file[list]) {
            if (!stem.is_object())
                continue;
            for (auto const& [key, value] : stem.items())
                if (!is_key_of_stem(key))
                    result.push_back(key);
        }
    }
    return result;
}

Result<LineSketchFile> read_sketch(json const& file, PictureReader const& pictures)
{
    if (!file.is_object())
        return fail(Fault::User,
                    "it is no sketch: write {\"pattern\": …, \"stem\": …, \"left\": …, "
                    "\"right\": …, \"inclinations\": …, \"nodes_per_layer\": …}");
    LineSketchFile result { .sketch = {},
                            .strokes = {},
                            .pattern = TRY(read_pattern(file)),
                            .unknown_keys = unknown_keys(file) };
    TRY(read_lines(file, result.sketch));
    // Errors about the number of nodes are returned only after the strokes have been read, because
    // errors in strokes are reported first.
    auto nodes = read_first_nodes(file, result.sketch);
    TRY(read_strokes(file, result));
    TRY(std::move(nodes));
    TRY(read_stems(file, result));
    auto organs = TRY(read_organs(file, result.pattern, pictures));
    result.layers = std::move(organs.layers);
    result.organs = std::move(organs.organs);
    result.organ = TRY(read_organ(file, pictures));
    return result;
}

// Position of a byte in a text as "LINE:COLUMN"; both numbers begin with 1.
std::string place_of(std::string_view text, std::size_t byte)
{
    auto const before = text.substr(0, byte > 0 ? byte - 1 : 0);
    auto const line = std::count(before.begin(), before.end(), '\n') + 1;
    auto const last_break = before.rfind('\n');
    auto const column
        = before.size() - (last_break == std::string_view::npos ? 0 : last_break + 1) + 1;
    return fmt::format("{}:{}", line, column);
}

Result<json> parse_json(std::string_view text, std::string const& name)
{
    try {
        return json::parse(text);
    } catch (json::parse_error const& error) {
        return fail(Fault::User,
                    fmt::format("{}:{}: this is no JSON: a bracket, comma or quotation "
                                "mark is missing or too many",
                                name, place_of(text, error.byte)));
    } catch (json::exception const&) {
        return fail(Fault::User,
                    fmt::format("{}: a number in it is too large: give millimetres", name));
    }
}

// Reads the sketch of a file. Values in `given` replace those in the file.
Result<LineSketchFile> read_file_sketch(Result<json> file, std::string const& name,
                                        SketchOverrides const& given)
{
    auto const pictures = [&](std::string const& picture) {
        return read_file(std::filesystem::path(name).parent_path() / picture,
                         lsystem::kMaxTextureBytes);
    };
    if (file && file->is_object()) {
        if (!given.pattern.empty())
            (*file)["pattern"] = given.pattern;
        if (!given.sizes.empty())
            (*file)["sizes"] = given.sizes;
        if (given.divergence_deg)
            (*file)["divergence"] = *given.divergence_deg;
        if (!given.nodes_per_layer.empty())
            (*file)["nodes_per_layer"] = given.nodes_per_layer;
    }
    auto result = read_sketch(TRY(std::move(file)), pictures);
    if (!result)
        return fail(result.error().fault, fmt::format("{}: {}", name, result.error().message));
    return result;
}

} // namespace

Result<LineSketchFile> parse_line_sketch(std::string_view text, std::string const& name,
                                         SketchOverrides const& given)
{
    return read_file_sketch(parse_json(text, name), name, given);
}

Result<LineSketchFile> load_line_sketch(std::filesystem::path const& path,
                                        SketchOverrides const& given)
{
    constexpr std::size_t kMaxBytes = std::size_t { 2 } << 20;
    auto const name = path.string();
    auto const text = TRY(read_text_file(path, kMaxBytes));
    if (path.extension() != ".svg")
        return parse_line_sketch(text, name, given);
    auto drawing = svg::svg_as_sketch(text);
    if (!drawing)
        return fail(drawing.error().fault, fmt::format("{}: {}", name, drawing.error().message));
    return read_file_sketch(std::move(drawing), name, given);
}

} // namespace tractus::lines
