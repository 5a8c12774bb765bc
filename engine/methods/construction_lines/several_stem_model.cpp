#include "engine/methods/construction_lines/line_model.h"

#include "engine/base/check.h"
#include "engine/methods/construction_lines/function_curves.h"
#include "engine/methods/construction_lines/line_rules.h"
#include "engine/methods/construction_lines/model_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

// Ratio of a stem's length to its diameter at the foot, unless its parent is too thin for that.
constexpr double kLengthByWidth = 60;
constexpr double kTaper = 0.7; // Share of its diameter that a stem loses towards its top.
// Share of its diameter that a stem loses towards its top if another stem is attached to the top.
constexpr double kForked = 0.4;

// A stem with its number in the model: stems attached to the same parent have consecutive numbers,
// from below.
struct ModelStem {
    MeasuredStem const* of = nullptr;
    std::size_t drawn = 0;       // Number of the stem in the sketch.
    std::size_t parent = 0;      // Number, in the model, of the parent stem.
    std::size_t first_borne = 0; // Number, in the model, of the first stem attached to this stem.
    std::size_t borne = 0;       // Number of stems attached to this stem.
    double width_cm = 0;         // Diameter of the stem at its foot.
    double taper = kTaper;       // Share of the diameter that the stem loses towards its top.
    std::size_t low = 0; // Index of the stem's first inclination line among those of all stems.
    // Number of functions before the stem's own two, heading and depth: rules count these from 1.
    std::size_t own_functions = 0;
    // Number of functions before those of the stem's organs, minus two: rules count these from 3.
    std::size_t organ_functions = 0;
    // Index of the azimuth of the stem's first boundary among those of all stems.
    std::size_t first_azimuth = 0;
};

double width_on(ModelStem const& parent, double foot_x)
{
    return parent.width_cm * (1 - parent.taper * foot_x);
}

void add_borne(std::vector<ModelStem>& result, std::span<MeasuredStem const> stems,
               std::size_t parent)
{
    auto const first = result.size();
    for (std::size_t i = 0; i < stems.size(); ++i)
        if (stems[i].parent == result[parent].drawn)
            result.push_back({ .of = &stems[i], .drawn = i, .parent = parent });
    std::stable_sort(
        result.begin() + static_cast<std::ptrdiff_t>(first), result.end(),
        [](ModelStem const& a, ModelStem const& b) { return a.of->foot_x < b.of->foot_x; });
    result[parent].first_borne = first;
    result[parent].borne = result.size() - first;
    if (result.size() > first && result.back().of->foot_x == 1)
        result[parent].taper = kForked;
}

std::vector<ModelStem> numbered(std::span<MeasuredStem const> stems)
{
    std::vector<ModelStem> result;
    for (std::size_t i = 0; i < stems.size(); ++i)
        if (!stems[i].parent)
            result.push_back({ .of = &stems[i], .drawn = i });
    for (std::size_t i = 0; i < result.size(); ++i) {
        auto& stem = result[i];
        stem.width_cm = stem.of->construction.stem.length_mm() / kLengthByWidth;
        if (stem.of->parent)
            stem.width_cm = std::min(stem.width_cm, width_on(result[stem.parent], stem.of->foot_x));
        add_borne(result, stems, i);
    }
    return result;
}

using Functions = std::vector<std::pair<std::string, std::string>>;

// Writes the function files of all stems. Each stem has its own heading and depth; stems with equal
// functions for their organs share these.
Functions write_functions(std::vector<ModelStem>& stems, std::string const& name)
{
    constexpr std::size_t kOwn = 2;
    Functions functions;
    std::vector<std::pair<std::vector<std::string>, std::size_t>> known;
    for (std::size_t i = 0; i < stems.size(); ++i) {
        auto const curves = function_curves(stems[i].of->construction);
        auto const add = [&](FunctionCurve const& curve) {
            functions.emplace_back(fmt::format("{}_{}_{}.func", name, i + 1, curve.name),
                                   function_file(curve));
        };
        stems[i].own_functions = functions.size();
        auto const organs_begin = curves.begin() + std::ptrdiff_t { kOwn };
        std::for_each(curves.begin(), organs_begin, add);
        std::vector<std::string> organs;
        std::transform(organs_begin, curves.end(), std::back_inserter(organs), function_file);
        auto const same = std::find_if(known.begin(), known.end(),
                                       [&](auto const& other) { return other.first == organs; });
        stems[i].organ_functions = same == known.end() ? functions.size() - kOwn : same->second;
        if (same != known.end())
            continue;
        known.emplace_back(std::move(organs), stems[i].organ_functions);
        std::for_each(organs_begin, curves.end(), add);
    }
    return functions;
}

// Rounds a number to the six digits in which it is written.
double rounded(double value)
{
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

// Number of derivation steps until all stems are complete.
std::size_t count_steps(std::vector<ModelStem> const& stems)
{
    std::vector<std::size_t> begins(stems.size(), 0);
    std::size_t last = 0;
    for (std::size_t i = 0; i < stems.size(); ++i) {
        auto const& stem = stems[i];
        auto const& of = stem.of->construction;
        std::size_t steps = begins[i];
        std::size_t next = stem.first_borne;
        auto const bear_below = [&](double y) {
            for (; next < stem.first_borne + stem.borne && rounded(stems[next].of->foot_x) <= y;
                 ++next)
                begins[next] = ++steps;
        };
        for (std::size_t k = 0; k < of.nodes_per_layer.size(); ++k) {
            double const from = rounded(of.inclinations[k].x);
            double const to = rounded(of.inclinations[k + 1].x);
            int const nodes = of.nodes_per_layer[k];
            for (int j = 0; j < nodes; ++j, ++steps)
                bear_below(j > 0 ? from + (to - from) * j / nodes : from);
            steps += nodes == 0 ? 1 : 0;
        }
        bear_below(rounded(of.inclinations.back().x));
        ++steps; // One step makes the topmost node.
        bear_below(1);
        last = std::max(last, ++steps);
    }
    return last;
}

// Collects the tables of the model: arrays of numbers, most of them indexed by the stem's number.
class Tables {
public:
    void add(char const* name, std::vector<double> const& values, char const* meaning)
    {
        text_ += fmt::format("{}{};{}", text_.empty() ? "define: { " : "          ",
                             array_text(name, values),
                             *meaning ? fmt::format("    /* {} */\n", meaning) : "\n");
    }
    std::string text() const { return text_ + "}\n"; }

private:
    std::string text_;
};

template<typename Read>
std::vector<double> of_each(std::vector<ModelStem> const& stems, Read const& read)
{
    std::vector<double> values;
    for (auto const& stem : stems)
        values.push_back(static_cast<double>(read(stem)));
    return values;
}

// The inclination lines of all stems, one stem after the other, and the azimuths of their
// boundaries. Stems that take their organs from the same stem share these entries.
struct Lines {
    // Azimuths of the boundaries of all stems, if sizes follow half-ellipses.
    std::vector<double> azimuths;
    std::vector<double> at;
    // Number of nodes in the layer above each line; 1 for a stem's topmost line, above which there
    // is no layer.
    std::vector<double> nodes;
    LayerTables layers;
    bool is_by_layer = false; // True if layers bear different organs.
};

void add_layers(LayerTables& tables, Construction const& construction)
{
    auto layers = construction.organs_per_layer;
    layers.resize(construction.nodes_per_layer.size() + 1); // One entry for each inclination line.
    for (auto const& layer : layers)
        tables.add(layer);
}

Lines write_lines(std::vector<ModelStem>& stems, Pattern const& pattern)
{
    Lines lines { .azimuths = {}, .at = {}, .nodes = {}, .layers = LayerTables(pattern) };
    for (std::size_t i = 0; i < stems.size(); ++i) {
        auto const& of = *stems[i].of;
        auto const same = std::find_if(
            stems.begin(), stems.begin() + static_cast<std::ptrdiff_t>(i),
            [&](ModelStem const& other) { return other.of->functions == of.functions; });
        if (same != stems.begin() + static_cast<std::ptrdiff_t>(i)) {
            stems[i].low = same->low;
            stems[i].first_azimuth = same->first_azimuth;
            continue;
        }
        stems[i].first_azimuth = lines.azimuths.size();
        auto const azimuths = azimuths_of(of.construction);
        lines.azimuths.insert(lines.azimuths.end(), azimuths.begin(), azimuths.end());
        stems[i].low = lines.at.size();
        for (auto const& line : of.construction.inclinations)
            lines.at.push_back(line.x);
        auto const& layers = of.construction.nodes_per_layer;
        lines.nodes.insert(lines.nodes.end(), layers.begin(), layers.end());
        lines.nodes.push_back(1);
        add_layers(lines.layers, of.construction);
        lines.is_by_layer = lines.is_by_layer || !of.construction.organs_per_layer.empty();
    }
    return lines;
}

void add_azimuths(Tables& tables, std::vector<ModelStem> const& stems, Lines const& lines)
{
    tables.add(
        "sides",
        of_each(stems, [](ModelStem const& stem) { return stem.of->construction.around.size(); }),
        "on so many of its sides boundaries are");
    tables.add("first", of_each(stems, [](ModelStem const& stem) { return stem.first_azimuth; }),
               "the azimuths around it begin here in the table below; the last is the first again");
    tables.add("azimuth", lines.azimuths, "degrees around the stem from its left");
}

void add_layers(Tables& tables, LayerTables const& layers)
{
    tables.add("organ", layers.organs(), "what each layer bears, 0 leaves");
    if (auto const numbers = layers.pattern_numbers(); !numbers.empty())
        tables.add("pattern", numbers, "in which of the patterns below");
    if (auto const rolls_deg = layers.rolls_deg(); !rolls_deg.empty())
        tables.add("roll", rolls_deg, "0 flat as in a frond, -90 upper side up");
}

std::string tables_text(std::vector<ModelStem> const& stems, Lines const& lines)
{
    Tables tables;
    tables.add(
        "length",
        of_each(stems,
                [](ModelStem const& stem) { return stem.of->construction.stem.length_mm(); }),
        "of each stem, cm");
    tables.add("width", of_each(stems, [](ModelStem const& stem) { return stem.width_cm; }),
               "its diameter at its foot, cm");
    tables.add("taper", of_each(stems, [](ModelStem const& stem) { return stem.taper; }),
               "how much of that it loses up to its top");
    tables.add("foot", of_each(stems, [](ModelStem const& stem) { return stem.of->foot_x; }),
               "where it stands on the stem that bears it, 0 to 1");
    auto bears = of_each(stems, [](ModelStem const& stem) { return stem.first_borne; });
    bears.push_back(static_cast<double>(stems.size()));
    tables.add("bears", bears, "it bears the stems from this number to below the next one's");
    tables.add("own", of_each(stems, [](ModelStem const& stem) { return stem.own_functions; }),
               "its heading and depth are functions 1 and 2 behind this number");
    tables.add("organs", of_each(stems, [](ModelStem const& stem) { return stem.organ_functions; }),
               "its organs' are functions 3 to 6 behind this number");
    tables.add(
        "layers",
        of_each(stems,
                [](ModelStem const& stem) { return stem.of->construction.nodes_per_layer.size(); }),
        "");
    tables.add("low", of_each(stems, [](ModelStem const& stem) { return stem.low; }),
               "its lines begin here in the two tables below");
    tables.add("at", lines.at, "where lines cross the stem, 0 to 1");
    tables.add("nodes", lines.nodes, "how many there are from each line to the next");
    if (lines.is_by_layer)
        add_layers(tables, lines.layers);
    if (!lines.azimuths.empty())
        add_azimuths(tables, stems, lines);
    return tables.text();
}

// Writes the turtle commands from the first stem's foot to another stem's foot, without drawing.
std::string way_text(Vec3 const& by_mm)
{
    if (by_mm.norm() < 1e-6)
        return "";
    double const heading_deg = degrees(std::atan2(-by_mm.x(), by_mm.y()));
    double const pitch_deg = degrees(std::atan2(by_mm.z(), by_mm.head<2>().norm()));
    auto const heading = format_model_number(heading_deg);
    auto const pitch = format_model_number(pitch_deg);
    if (pitch == "0")
        return fmt::format("+({0})f({1:.6g})-({0})", heading, by_mm.norm());
    return fmt::format("+({0})^({1})f({2:.6g})&({1})-({0})", heading, pitch, by_mm.norm());
}

std::string axiom(std::vector<ModelStem> const& stems)
{
    std::string text = "Axiom:";
    Vec3 const first = stems.front().of->construction.stem.point(0);
    for (std::size_t i = 0; i < stems.size(); ++i)
        if (!stems[i].of->parent)
            text += fmt::format(" [{}+(func({}, 0))^(func({}, 0))A({}, 0, 0, 0, 0, {})]",
                                way_text(stems[i].of->construction.stem.point(0) - first),
                                stems[i].own_functions + 1, stems[i].own_functions + 2, i,
                                stems[i].first_borne);
    return text + "\n\n";
}

double longest_piece_of(std::vector<ModelStem> const& stems)
{
    double longest = kLongPiece;
    for (auto const& stem : stems)
        longest = std::min(longest, longest_piece(stem.of->construction.stem));
    return longest;
}

// Returns the stems with the sizes that the model needs: they follow half-ellipses either in all
// stems or in none.
std::vector<MeasuredStem> stems_with_sizes(std::span<MeasuredStem const> stems, Pattern pattern)
{
    if (std::any_of(stems.begin(), stems.end(),
                    [](MeasuredStem const& stem) { return !stem.construction.around.empty(); }))
        pattern.sizes = Pattern::Sizes::HalfEllipses;
    std::vector<MeasuredStem> result(stems.begin(), stems.end());
    for (auto& stem : result)
        stem.construction = with_sizes_around(std::move(stem.construction), pattern);
    return result;
}

} // namespace

LineModel write_model(std::span<MeasuredStem const> measured, Pattern const& pattern,
                      std::string const& name)
{
    CHECK(!measured.empty());
    if (measured.size() == 1)
        return write_model(measured.front().construction, pattern, name);
    auto const stems = stems_with_sizes(measured, pattern);
    auto const sizes = stems.front().construction.around.empty() ? Pattern::Sizes::Linear
                                                                 : Pattern::Sizes::HalfEllipses;
    auto of_model = numbered(stems);
    auto const functions = write_functions(of_model, name);
    auto const lines = write_lines(of_model, pattern);
    StemDefinitions const each { .length = "length[s]",
                                 .of = "stem s",
                                 .width = "width[s]",
                                 .layers = "layers[s]",
                                 .longest_piece = longest_piece_of(of_model),
                                 .rolls_by_layer
                                 = lines.is_by_layer && !lines.layers.rolls_deg().empty() };
    auto text = fmt::format(
        "/* A plant of {} stems from construction lines, its organs {}. Tables say of each stem "
        "which\n"
        "   functions of the place x on it, 0 to 1, are its own, among the files that the view "
        "names:\n"
        "   1 its heading, 2 its depth, 3 and 4 the organs' angles on the left and the right, 5 "
        "and 6\n"
        "   their sizes; 7, the way to the next node, is for other models{}. A step makes a node, "
        "or "
        "a\n"
        "   stem that stands on another. */\n"
        "{}\n"
        "Lsystem: 1\n"
        "derivation length: {}\n"
        "{}{}{}endlsystem\n",
        stems.size(), name_of(pattern.kind),
        lines.azimuths.empty() ? "" : "; 8 and on sizes, too, at azimuths around the stem",
        definitions_text(each, pattern), count_steps(of_model), tables_text(of_model, lines),
        axiom(of_model),
        stem_rules(pattern, Stems::Several, sizes, lines.is_by_layer ? &lines.layers : nullptr));
    return model_with(std::move(text), functions, pattern, name);
}

} // namespace tractus::lines
