#include "engine/methods/construction_lines/composed_model.h"

#include "engine/methods/construction_lines/function_curves.h"
#include "engine/methods/construction_lines/line_rules.h"
#include "engine/methods/construction_lines/model_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace tractus::lines {

namespace {

// A sketch as the model numbers it.
struct SubModel {
    Construction construction; // With its sizes around.
    Pattern pattern {};
    std::vector<std::size_t> called {}; // The model's numbers of its organs, from 1.
    std::vector<std::size_t> organ_of_layer {};
    std::size_t offset = 0; // So many functions come before its own.
    std::size_t steps = 0;  // Until it and its organs are there.
    double leaves = 0;      // Of its plant.
};

std::size_t organ_of(ComposedSketch const& sketch, std::size_t layer)
{
    auto const& list = sketch.organ_of_layer;
    return list.empty() ? 0 : list[std::min(layer, list.size() - 1)];
}

// How many organs each layer has; the topmost line's are those of the last one.
std::vector<double> organs_of_layers(Construction const& construction, Pattern const& pattern)
{
    std::vector<double> organs;
    for (auto const nodes : construction.nodes_per_layer)
        organs.push_back(nodes * organs_at_node(pattern));
    organs.back() += organs_at_node(pattern);
    return organs;
}

// Adds the sketch and what it calls, and gives its number, from 0.
Result<std::size_t> add_sub_model(std::vector<SubModel>& models, ComposedSketch const& sketch)
{
    if (models.size() >= kMostSketches)
        return fail(Fault::User,
                    fmt::format("the plant is composed of more than {} sketches: leave some out",
                                kMostSketches));
    auto const number = models.size();
    models.push_back({ .construction = with_sizes_around(sketch.construction, sketch.pattern),
                       .pattern = sketch.pattern });
    std::vector<std::size_t> called;
    for (auto const& organ : sketch.organs)
        called.push_back(TRY(add_sub_model(models, organ)));
    auto& model = models[number];
    auto const organs = organs_of_layers(model.construction, model.pattern);
    std::size_t behind = 0; // Steps.
    for (std::size_t layer = 0; layer < organs.size(); ++layer) {
        auto const organ = organ_of(sketch, layer);
        if (organ > called.size())
            return fail(Fault::User,
                        fmt::format("layer {} is to bear organ {}, but there are {}", layer + 1,
                                    organ, called.size()));
        model.organ_of_layer.push_back(organ);
        model.leaves += organs[layer] * (organ == 0 ? 1 : models[called[organ - 1]].leaves);
        if (organ > 0)
            behind = std::max(behind, models[called[organ - 1]].steps);
    }
    constexpr std::size_t kOrganSteps = 4; // From a node to its organ's call.
    model.steps = count_steps(model.construction) + kOrganSteps + behind;
    model.called = std::move(called);
    return number;
}

// A name of a definition that each of the models has.
bool is_own_name(std::string_view word)
{
    constexpr std::array<std::string_view, 8> kNames { "LEN",    "STEM",       "DX",    "ROLL",
                                                       "LAYERS", "DIVERGENCE", "WHORL", "SIDES" };
    return std::find(kNames.begin(), kNames.end(), word) != kNames.end();
}

std::string own_name(std::string_view name, std::size_t number)
{
    return number == 0 ? std::string(name) : fmt::format("{}_{}", name, number + 1);
}

// The text with the names of its definitions as this model has them.
std::string with_own_names(std::string_view text, std::size_t number)
{
    std::string result;
    std::size_t at = 0;
    auto const is_of_word = [&](std::size_t i) {
        return i < text.size()
            && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
    };
    while (at < text.size()) {
        auto const begin = at;
        while (is_of_word(at))
            ++at;
        auto const word = text.substr(begin, at - begin);
        result += is_own_name(word) ? own_name(word, number) : std::string(word);
        if (at < text.size())
            result += text[at++];
    }
    return result;
}

void replace_all(std::string& text, std::string_view word, std::string_view with)
{
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size()))
        text.replace(at, word.size(), with);
}

char letter_of(std::size_t number)
{
    constexpr std::string_view kLetters = "lmnopqrstuvw";
    static_assert(kLetters.size() == kMostSketches);
    return kLetters[number];
}

// Organs that are models: their stems are as long as the leaves would be.
std::string calls_text(std::vector<SubModel> const& models, std::size_t number)
{
    std::string text;
    auto const& model = models[number];
    for (std::size_t i = 0; i < model.called.size(); ++i) {
        auto const called = model.called[i];
        auto const offset = models[called].offset;
        text
            += fmt::format("Q(z, h) : organ[z] == {}\n"
                           "    --> ?({}, h * {} / {})+(func({}, 0))^(func({}, 0))A(0, 0, 0, 0)$\n",
                           i + 1, called + 1, own_name("LEN", number), own_name("LEN", called),
                           offset + 1, offset + 2);
    }
    return text;
}

std::string definitions_of(SubModel const& model, std::size_t number)
{
    auto const sides = model.construction.around.size();
    return with_own_names(
        definitions_text({ .length = fmt::format("{:.6g}", model.construction.stem.length_mm()),
                           .of = "the stem",
                           .width = "(LEN / 60)",
                           .layers = std::to_string(model.construction.nodes_per_layer.size()),
                           .longest_piece = longest_piece(model.construction.stem),
                           .sides = sides == 0 ? "" : std::to_string(sides) },
                         model.pattern),
        number);
}

std::string system_text(std::vector<SubModel> const& models, std::size_t number)
{
    auto const& model = models[number];
    auto const sizes
        = model.construction.around.empty() ? Pattern::Sizes::Linear : Pattern::Sizes::HalfEllipses;
    auto rules = with_own_names(stem_rules(model.pattern, Stems::Composed, sizes), number);
    if (model.offset == 0)
        replace_all(rules, "<offset> + ", "");
    replace_all(rules, "<offset>", std::to_string(model.offset));
    replace_all(rules, "<calls>", calls_text(models, number));
    replace_all(rules, "~l(", fmt::format("~{}(", letter_of(number)));
    auto arrays = arrays_of(model.construction);
    arrays.push_back(
        array_text("organ", { model.organ_of_layer.begin(), model.organ_of_layer.end() }));
    return fmt::format("Lsystem: {}\n"
                       "derivation length: {}\n"
                       "define: {{ {}; }}\n"
                       "Axiom: +(func({}, 0))^(func({}, 0))A(0, 0, 0, 0)\n\n"
                       "{}endlsystem\n",
                       number + 1, model.steps, fmt::join(arrays, ";\n          "),
                       model.offset + 1, model.offset + 2, rules);
}

} // namespace

Result<LineModel> write_composed_model(ComposedSketch const& sketch, std::string const& name)
{
    std::vector<SubModel> models;
    TRY(add_sub_model(models, sketch));
    if (models.front().leaves > static_cast<double>(kMostComposedLeaves))
        return fail(Fault::User,
                    fmt::format("the plant would have {:.0f} leaves, more than {}: give its layers "
                                "fewer nodes",
                                models.front().leaves, kMostComposedLeaves));
    std::vector<std::pair<std::string, std::string>> functions;
    std::string definitions;
    std::string leaves;
    for (std::size_t i = 0; i < models.size(); ++i) {
        models[i].offset = functions.size();
        for (auto const& curve : function_curves(models[i].construction))
            functions.emplace_back(fmt::format("{}_{}_{}.func", name, i + 1, curve.name),
                                   function_file(curve));
        definitions += definitions_of(models[i], i);
        if (i > 0)
            leaves += leaf_text(letter_of(i), models[i].pattern);
    }
    auto text = fmt::format(
        "/* A plant of {} sketches of construction lines: organs of one are plants of another, "
        "which "
        "is an\n"
        "   L-system that it calls. The functions of the place x on a stem, 0 to 1, are files that "
        "the view\n"
        "   names, for each sketch: its stem's heading and depth, the organs' angles on the left "
        "and "
        "the\n"
        "   right, their sizes there, and, for other models, the way to the next node. A step "
        "makes a "
        "node. */\n"
        "{}",
        models.size(), definitions);
    for (std::size_t i = 0; i < models.size(); ++i)
        text.append("\n").append(system_text(models, i));
    auto model = model_with(std::move(text), functions, sketch.pattern, name);
    model.source.view_text += leaves;
    return model;
}

} // namespace tractus::lines
