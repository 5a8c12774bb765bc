#include "engine/methods/construction_lines/model_text.h"

#include "engine/methods/construction_lines/function_curves.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

std::string format_model_number(double value)
{
    auto text = fmt::format("{:.6g}", value + 0.0);
    return text.front() == '-' ? "(" + text + ")" : text;
}

void replace_all(std::string& text, std::string_view word, std::string_view with)
{
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size()))
        text.replace(at, word.size(), with);
}

std::string array_text(char const* name, std::vector<double> const& values)
{
    std::string text;
    for (auto const value : values)
        text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", value);
    return fmt::format("array {}[{}] = {{{}}}", name, values.size(), text);
}

// Maximum length of a stem's pieces in the model: shorter for a stem with corners or tight bends.
double longest_piece(DrawnStem const& stem)
{
    constexpr int kSteps = 100;
    // A stem has tight bends if it turns by more than this within a hundredth of its length.
    constexpr double kCurved_deg = 2;
    constexpr double kCorner_deg = 5;
    if (stem.sharpest_deg() > kCorner_deg)
        return kShortPiece;
    for (int i = 1; i <= kSteps; ++i) {
        auto const before = stem.course((i - 1.0) / kSteps);
        auto const after = stem.course(static_cast<double>(i) / kSteps);
        if (std::fabs(after.heading_deg - before.heading_deg) > kCurved_deg
            || std::fabs(after.pitch_deg - before.pitch_deg) > kCurved_deg)
            return kShortPiece;
    }
    return kLongPiece;
}

std::string definitions_text(StemDefinitions const& stem, Pattern const& pattern)
{
    auto text = fmt::format(
        "#define LEN        {}    /* of {}, cm */\n"
        "#define STEM       {}    /* the stem's diameter at its foot, cm */\n"
        "#define DX         {}    /* the longest piece the stem is drawn in, by LEN */\n",
        stem.length, stem.of, stem.width, stem.longest_piece);
    if (!stem.rolls_by_layer)
        text += fmt::format(
            "#define ROLL       {}    /* of organs: 0 flat as in a frond, (-90) upper side up */\n",
            format_model_number(roll_deg(pattern)));
    text += fmt::format("#define LAYERS     {}\n", stem.layers);
    if (pattern.kind == Pattern::Kind::Spiral || pattern.kind == Pattern::Kind::Alternate)
        text += fmt::format("#define DIVERGENCE {}    /* from organ to organ, degrees */\n",
                            format_model_number(pattern.divergence_deg));
    if (pattern.kind == Pattern::Kind::Whorled)
        text += fmt::format("#define WHORL      {}    /* how many organs stand at a node */\n",
                            pattern.whorl);
    if (!stem.sides.empty())
        text += fmt::format(
            "#define SIDES      {}    /* on so many of the stem boundaries are */\n", stem.sides);
    return text;
}

Construction with_sizes_around(Construction construction, Pattern const& pattern)
{
    if (!has_organs_all_around(pattern, construction.organs_per_layer)) {
        construction.around.clear();
        return construction;
    }
    if (pattern.sizes == Pattern::Sizes::Linear || !construction.around.empty())
        return construction;
    AzimuthSizes left { 0, {} };
    AzimuthSizes right { 180, {} };
    for (auto const& node : construction.nodes) {
        left.sizes.push_back(node.left_size);
        right.sizes.push_back(node.right_size);
    }
    construction.around = { std::move(left), std::move(right) };
    return construction;
}

std::vector<double> azimuths_of(Construction const& construction)
{
    std::vector<double> azimuths;
    for (auto const& side : construction.around)
        azimuths.push_back(side.azimuth_deg);
    if (!azimuths.empty())
        azimuths.push_back(azimuths.front() + 360);
    return azimuths;
}

std::size_t count_steps(Construction const& construction)
{
    auto const& layers = construction.nodes_per_layer;
    return construction.nodes.size()
        + static_cast<std::size_t>(std::count(layers.begin(), layers.end(), 0));
}

std::vector<std::string> arrays_of(Construction const& construction)
{
    std::vector<double> places;
    for (auto const& line : construction.inclinations)
        places.push_back(line.x);
    auto const& layers = construction.nodes_per_layer;
    std::vector<std::string> arrays { array_text("at", places),
                                      array_text("nodes", { layers.begin(), layers.end() }) };
    if (!construction.around.empty())
        arrays.push_back(array_text("azimuth", azimuths_of(construction)));
    return arrays;
}

std::vector<std::string> arrays_of(LayerTables const& layers)
{
    std::vector<std::string> arrays { array_text("organ", layers.organs()) };
    if (auto const numbers = layers.pattern_numbers(); !numbers.empty())
        arrays.push_back(array_text("pattern", numbers));
    if (auto const rolls_deg = layers.rolls_deg(); !rolls_deg.empty())
        arrays.push_back(array_text("roll", rolls_deg));
    return arrays;
}

std::string leaf_statement(char letter, Pattern const& pattern)
{
    constexpr double kBroad = 0.4;
    // Width of the narrow leaflets of a frond, which lie side by side, as a share of their length.
    constexpr double kSlender = 0.25;
    return fmt::format(
        "organ: {} leaf kind=blade material=2 length=1 width={} petiole=0 widest=0.4 "
        "tip=0.8 base=0.5 fold=8 curl=0\n",
        letter, pattern.kind == Pattern::Kind::Distichous ? kSlender : kBroad);
}

static std::string view_text(std::vector<std::pair<std::string, std::string>> const& functions,
                             Pattern const& pattern)
{
    std::string text = "angle increment: 45\n"
                       "initial line width: 1\n"
                       "initial color: 1\n";
    for (auto const& function : functions)
        text += fmt::format("function: {} {}\n", function.first, kFunctionSamples);
    text += "material: 1 stem kind=stem color=0.36,0.46,0.20 roughness=0.7\n"
            "material: 2 leaf kind=leaf color=0.26,0.46,0.16 roughness=0.5 translucency=0.45\n";
    return text + leaf_statement('l', pattern);
}

LineModel model_with(std::string text,
                     std::vector<std::pair<std::string, std::string>> const& functions,
                     Pattern const& pattern, std::string const& name)
{
    LineModel model;
    for (auto const& [file, curve] : functions)
        model.functions[file] = curve;
    model.source.name = name + ".l";
    model.source.view_name = name + ".v";
    model.source.view_text = view_text(functions, pattern);
    model.source.text = std::move(text);
    return model;
}

} // namespace tractus::lines
