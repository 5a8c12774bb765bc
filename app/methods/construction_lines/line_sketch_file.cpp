#include "app/methods/construction_lines/line_sketch_file.h"

#include "app/svg/svg_sketch.h"
#include "engine/base/file.h"
#include "engine/methods/construction_lines/around_stem.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace tractus::lines {

namespace {

using nlohmann::json;

constexpr std::array kStemKeys { "stem",       "left",         "right",
                                 "boundaries", "inclinations", "nodes_per_layer" };
constexpr std::array kOtherKeys { "pattern", "divergence", "sizes", "organs",
                                  "organ",   "strokes",    "stems" };
constexpr std::array kOrganKeys { "left", "right", "midrib", "section" };
constexpr std::size_t kMostStrokes = 100; // And stems.

// Not there, or said to be so.
bool has(json const& file, char const* key)
{
    auto const found = file.find(key);
    return found != file.end() && !found->is_null();
}

Result<Vec3> read_point(json const& value, std::string const& place)
{
    bool const is_point = value.is_array() && (value.size() == 2 || value.size() == 3)
        && std::all_of(value.begin(), value.end(),
                       [](json const& part) { return part.is_number(); });
    if (!is_point)
        return fail(Fault::User, fmt::format("{} is no point: write [u, v] in millimetres", place));
    return Vec3(value[0].get<double>(), value[1].get<double>(),
                value.size() == 3 ? value[2].get<double>() : 0);
}

Result<std::vector<Vec3>> read_line(json const& value, std::string const& name)
{
    if (!value.is_array())
        return fail(Fault::User,
                    fmt::format("{} is no line: write [[u, v], [u, v]] in millimetres", name));
    std::vector<Vec3> points;
    for (auto const& point : value)
        points.push_back(
            TRY(read_point(point, fmt::format("point {} of {}", points.size() + 1, name))));
    return points;
}

Result<std::vector<Vec2>> read_flat_line(json const& value, std::string const& name)
{
    std::vector<Vec2> points;
    for (auto const& point : TRY(read_line(value, name)))
        points.push_back(point.head<2>());
    return points;
}

// After the stem: one whose depth is another one than the stem's is in space.
Result<std::vector<Vec2>> read_side(json const& file, char const* key, LineSketch& sketch)
{
    if (!has(file, key))
        return std::vector<Vec2>();
    auto line = TRY(read_line(file[key], key));
    if (depth_of(line, sketch.stem) <= kFlat)
        return read_flat_line(file[key], key);
    sketch.around.push_back(std::move(line));
    return std::vector<Vec2>();
}

Result<void> read_boundaries(json const& file, LineSketch& sketch)
{
    if (!has(file, "boundaries"))
        return {};
    auto const& lines = file["boundaries"];
    if (!lines.is_array() || lines.size() > kMostStrokes)
        return fail(Fault::User,
                    fmt::format("boundaries is no list of at most {} lines: write [[[u, v, w], [u, "
                                "v, w]]]",
                                kMostStrokes));
    int number = 0;
    for (auto const& line : lines)
        sketch.around.push_back(TRY(read_line(line, fmt::format("boundary {}", ++number))));
    return {};
}

Result<void> read_lines(json const& file, LineSketch& sketch)
{
    if (has(file, "stem"))
        sketch.stem = TRY(read_line(file["stem"], "stem"));
    sketch.left = TRY(read_side(file, "left", sketch));
    sketch.right = TRY(read_side(file, "right", sketch));
    TRY(read_boundaries(file, sketch));
    if (!has(file, "inclinations"))
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
                    kMostNodesInLayer));
        nodes.push_back(static_cast<int>(count));
    }
    return nodes;
}

// A stroke that begins another stem.
Result<void> read_stem_stroke(json const& stroke, LineSketchFile& result)
{
    auto const name = fmt::format("stroke {}", result.strokes.size() + 1);
    if (!has(stroke, "stem"))
        return fail(Fault::User,
                    fmt::format("{} is no line: write [[u, v], [u, v]], or {{\"stem\": [[u, v], "
                                "[u, v]]}} for another stem",
                                name));
    auto nodes = result.sketch.nodes_per_layer;
    if (has(stroke, "nodes_per_layer"))
        nodes = TRY(read_nodes(stroke["nodes_per_layer"], "nodes_per_layer of " + name));
    result.stem_strokes[result.strokes.size()] = std::move(nodes);
    result.strokes.push_back(TRY(read_line(stroke["stem"], name)));
    return {};
}

// After the numbers of nodes.
Result<void> read_strokes(json const& file, LineSketchFile& result)
{
    if (!has(file, "strokes"))
        return {};
    auto const& strokes = file["strokes"];
    if (!strokes.is_array() || strokes.size() > kMostStrokes)
        return fail(Fault::User,
                    fmt::format("strokes is no list of at most {} lines: write [[[u, v], [u, v]], "
                                "[[u, v], [u, v]]], the stem first",
                                kMostStrokes));
    for (auto const* const key : { "stem", "left", "right", "boundaries", "inclinations", "stems" })
        if (has(file, key))
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

// After those of the first one, whose numbers of nodes are there where it says none.
Result<void> read_stems(json const& file, LineSketchFile& result)
{
    if (!has(file, "stems"))
        return {};
    auto const& stems = file["stems"];
    if (!stems.is_array() || stems.size() >= kMostStrokes)
        return fail(Fault::User,
                    fmt::format("stems is no list of fewer than {} stems: write [{{\"stem\": [[u, "
                                "v], [u, v]]}}]",
                                kMostStrokes));
    for (auto const& stem : stems) {
        auto const name = fmt::format("stem {}", result.more_stems.size() + 2);
        if (!stem.is_object() || !has(stem, "stem"))
            return fail(Fault::User,
                        fmt::format("{} has no line: write {{\"stem\": [[u, v], [u, v]]}}", name));
        LineSketch sketch { .stem = {},
                            .left = {},
                            .right = {},
                            .inclinations = {},
                            .nodes_per_layer = result.sketch.nodes_per_layer };
        if (auto const lines = read_lines(stem, sketch); !lines)
            return fail(lines.error().fault, fmt::format("{}: {}", name, lines.error().message));
        if (has(stem, "nodes_per_layer"))
            sketch.nodes_per_layer
                = TRY(read_nodes(stem["nodes_per_layer"], "nodes_per_layer of " + name));
        result.more_stems.push_back(std::move(sketch));
    }
    return {};
}

Result<void> read_first_nodes(json const& file, LineSketch& sketch)
{
    if (!has(file, "nodes_per_layer"))
        return fail(Fault::User,
                    "nodes_per_layer is missing: give the number of nodes of each layer "
                    "between two neighbouring inclination lines, such as [5], or --nodes 5");
    sketch.nodes_per_layer = TRY(read_nodes(file["nodes_per_layer"], "nodes_per_layer"));
    return {};
}

// "whorled(N)" or "whorled", of three.
std::optional<int> whorl_of(std::string_view word)
{
    constexpr std::string_view kWhorled = "whorled";
    if (!word.starts_with(kWhorled))
        return std::nullopt;
    word.remove_prefix(kWhorled.size());
    if (word.empty())
        return Pattern().whorl;
    if (!word.starts_with('(') || !word.ends_with(')'))
        return std::nullopt;
    word = word.substr(1, word.size() - 2);
    int count = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || end != word.data() + word.size() || count < 2 || count > 24)
        return std::nullopt;
    return count;
}

Result<Pattern> read_pattern_word(json const& file)
{
    constexpr std::string_view kWhatToGive = "give \"distichous\", \"decussate\", \"spiral\", "
                                             "\"alternate\", or \"whorled(N)\" with N from 2 to 24";
    if (!has(file, "pattern") || !file["pattern"].is_string())
        return fail(Fault::User, fmt::format("pattern is missing: {}", kWhatToGive));
    auto const& word = file["pattern"].get_ref<std::string const&>();
    Pattern pattern;
    if (auto const count = whorl_of(word)) {
        pattern.kind = Pattern::Kind::Whorled;
        pattern.whorl = *count;
        return pattern;
    }
    using enum Pattern::Kind;
    for (auto const kind : { Distichous, Decussate, Spiral, Alternate })
        if (word == name_of(kind)) {
            pattern.kind = kind;
            return pattern;
        }
    return fail(Fault::User, fmt::format("pattern is \"{}\": {}", word.substr(0, 40), kWhatToGive));
}

Result<Pattern::Sizes> read_sizes(json const& file)
{
    if (!has(file, "sizes") || file["sizes"] == "linear")
        return Pattern::Sizes::Linear;
    if (file["sizes"] == "half-ellipses")
        return Pattern::Sizes::HalfEllipses;
    return fail(Fault::User,
                "sizes is no way to change around the stem: give \"linear\" or "
                "\"half-ellipses\"");
}

Result<Pattern> read_pattern(json const& file)
{
    auto pattern = TRY(read_pattern_word(file));
    pattern.sizes = TRY(read_sizes(file));
    if (pattern.kind == Pattern::Kind::Alternate)
        pattern.divergence_deg = 180;
    if (!has(file, "divergence"))
        return pattern;
    auto const& value = file["divergence"];
    double const divergence_deg = value.is_number() ? value.get<double>() : std::nan("");
    if (!(std::fabs(divergence_deg) <= 360))
        return fail(Fault::User, "divergence is no angle: give degrees from -360 to 360");
    if (pattern.kind == Pattern::Kind::Spiral || pattern.kind == Pattern::Kind::Alternate)
        pattern.divergence_deg = divergence_deg;
    return pattern;
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
        if (!has(file, list))
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

Result<std::vector<std::string>> read_organs(json const& file)
{
    std::vector<std::string> organs;
    if (!has(file, "organs"))
        return organs;
    auto const list = file["organs"].is_array() ? file["organs"] : json::array({ file["organs"] });
    for (auto const& organ : list) {
        if (!organ.is_null() && !organ.is_string())
            return fail(Fault::User,
                        "organs are no sketches: write [\"leaf.json\", null], for each layer from "
                        "below the file of a sketch, or null for leaves");
        organs.push_back(organ.is_null() ? "" : organ.get<std::string>());
    }
    return organs;
}

Result<std::optional<OrganViews>> read_organ(json const& file)
{
    if (!has(file, "organ"))
        return std::nullopt;
    auto const& organ = file["organ"];
    if (!organ.is_object())
        return fail(Fault::User,
                    "organ is no leaf's shape: write {\"left\": [[u, v], [u, v]], \"right\": …, "
                    "\"midrib\": …, \"section\": …}");
    for (auto const& [key, value] : organ.items())
        if (std::find(kOrganKeys.begin(), kOrganKeys.end(), key) == kOrganKeys.end())
            return fail(
                Fault::User,
                fmt::format("organ has no line \"{}\": give left, right, midrib and section",
                            key.substr(0, 40)));
    OrganViews views;
    std::array const lines { &views.left, &views.right, &views.midrib, &views.section };
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (has(organ, kOrganKeys[i]))
            *lines[i] = TRY(read_flat_line(organ[kOrganKeys[i]],
                                           fmt::format("{} of the organ", kOrganKeys[i])));
    TRY(organ_surface(views)); // Fails where there is none.
    return views;
}

Result<LineSketchFile> read_sketch(json const& file)
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
    auto nodes = read_first_nodes(file, result.sketch); // What is wrong with strokes comes first.
    TRY(read_strokes(file, result));
    TRY(std::move(nodes));
    TRY(read_stems(file, result));
    result.organs = TRY(read_organs(file));
    result.organ = TRY(read_organ(file));
    return result;
}

// "LINE:COLUMN" of a byte, both from 1.
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

// A file's sketch with what is given besides it.
Result<LineSketchFile> read_file_sketch(Result<json> file, std::string const& name,
                                        GivenBesides const& given)
{
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
    auto result = read_sketch(TRY(std::move(file)));
    if (!result)
        return fail(result.error().fault, fmt::format("{}: {}", name, result.error().message));
    return result;
}

} // namespace

Result<LineSketchFile> parse_line_sketch(std::string_view text, std::string const& name,
                                         GivenBesides const& given)
{
    return read_file_sketch(parse_json(text, name), name, given);
}

Result<LineSketchFile> load_line_sketch(std::filesystem::path const& path,
                                        GivenBesides const& given)
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
