#include "engine/methods/construction_lines/composed_model.h"

#include "engine/base/check.h"
#include "engine/methods/construction_lines/function_curves.h"
#include "engine/methods/construction_lines/layer_organs.h"
#include "engine/methods/construction_lines/line_rules.h"
#include "engine/methods/construction_lines/model_text.h"
#include "engine/methods/construction_lines/organ_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace tractus::lines {

namespace {

// A sketch as one of the L-systems of a composed model.
struct SubModel {
    Construction construction; // The measured stem of the sketch, with sizes around it.
    Pattern pattern {};
    std::vector<LineOrgan> organs {};
    // For each organ, the index of its sketch among the sub-models; 0 for organs that are surfaces.
    std::vector<std::size_t> called {};
    std::vector<LayerOrgans> layers {}; // Organs of all layers, from below.
    OrganSurface leaf {};
    // Number of organ surfaces in the sketches before this one.
    std::size_t first_surface = 0;
    std::size_t offset = 0; // Number of functions of the sketches before this one.
    std::size_t steps = 0; // Number of derivation steps until the stem and its organs are complete.
    double leaves = 0;     // Number of leaves of the sketch's plant.

    LayerTables tables() const
    {
        LayerTables tables(pattern);
        for (auto const& layer : layers)
            tables.add(layer);
        return tables;
    }
};

// Returns the organs of each layer, from below, even if all layers have the plant's organs.
std::vector<LayerOrgans> all_layers(Construction const& construction)
{
    auto layers = construction.organs_per_layer;
    layers.resize(construction.nodes_per_layer.size());
    return layers;
}

// Number of organs of each layer, from below. The last layer includes those at the topmost
// inclination line.
std::vector<double> organs_of_layers(SubModel const& model)
{
    std::vector<double> organs;
    auto const at_node = [&](LayerOrgans const& layer) {
        return organs_at_node(layer.pattern.value_or(model.pattern));
    };
    for (std::size_t layer = 0; layer < model.layers.size(); ++layer)
        organs.push_back(model.construction.nodes_per_layer[layer] * at_node(model.layers[layer]));
    organs.back() += at_node(model.layers.back());
    return organs;
}

Result<std::size_t> add_sub_model(std::vector<SubModel>& models, ComposedSketch const& sketch);

// Adds the sketches that a sketch uses as organs to the models, and computes the number of
// derivation steps and leaves of the sketch. `number` is its index among the models.
Result<void> add_called(std::vector<SubModel>& models, std::size_t number)
{
    std::vector<std::size_t> called;
    auto const organs = models[number].organs;
    for (auto const& organ : organs)
        called.push_back(organ.sketch ? TRY(add_sub_model(models, *organ.sketch)) : 0);
    auto& model = models[number];
    auto const counts = organs_of_layers(model);
    std::size_t behind = 0; // Largest number of derivation steps of any organ of the stem.
    for (std::size_t layer = 0; layer < counts.size(); ++layer) {
        auto const organ = model.layers[layer].organ;
        if (organ > called.size())
            return fail(Fault::User,
                        fmt::format("layer {} is to bear organ {}, but there are {}", layer + 1,
                                    organ, called.size()));
        auto const* const plant
            = organ > 0 && organs[organ - 1].sketch ? &models[called[organ - 1]] : nullptr;
        model.leaves += counts[layer] * (plant ? plant->leaves : 1);
        behind = std::max(behind, plant ? plant->steps : 0);
    }
    // Number of derivation steps from the creation of a node to the call of its organ.
    constexpr std::size_t kOrganSteps = 4;
    model.steps = count_steps(model.construction) + kOrganSteps + behind;
    model.called = std::move(called);
    return {};
}

// Adds a sketch, and the sketches that it uses as organs, to the models. Returns the sketch's
// index, from 0.
Result<std::size_t> add_sub_model(std::vector<SubModel>& models, ComposedSketch const& sketch)
{
    if (models.size() >= kMaxSketches)
        return fail(Fault::User,
                    fmt::format("the plant is composed of more than {} sketches: leave some out",
                                kMaxSketches));
    if (sketch.stems.size() > 1)
        return fail(Fault::User, "a sketch that is an organ has one stem: leave the others out");
    auto const number = models.size();
    auto const& construction = sketch.stems.front().construction;
    models.push_back({ .construction = with_sizes_around(construction, sketch.pattern),
                       .pattern = sketch.pattern,
                       .organs = sketch.organs,
                       .layers = all_layers(construction),
                       .leaf = sketch.leaf });
    TRY(add_called(models, number));
    return number;
}

// True for the name of a macro that each L-system of a composed model defines with its own value.
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

// Returns an L-system's text with its number appended to the names of its own macros
// (is_own_name()), so that they differ from those of the other L-systems.
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

char letter_of(std::size_t number)
{
    constexpr std::string_view kLetters = "lmnopqrstuvw";
    static_assert(kLetters.size() == kMaxSketches);
    return kLetters[number];
}

// Writes the productions for organs that are sketches. The stem of such an organ is as long as a
// leaf would be.
std::string calls_text(std::vector<SubModel> const& models, std::size_t number)
{
    std::string text;
    auto const& model = models[number];
    for (std::size_t i = 0; i < model.called.size(); ++i) {
        if (!model.organs[i].sketch)
            continue;
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
                           .sides = sides == 0 ? "" : std::to_string(sides),
                           .rolls_by_layer = !model.tables().rolls_deg().empty() },
                         model.pattern),
        number);
}

std::string system_text(std::vector<SubModel> const& models, std::size_t number)
{
    auto const& model = models[number];
    auto const sizes
        = model.construction.around.empty() ? Pattern::Sizes::Linear : Pattern::Sizes::HalfEllipses;
    auto const tables = model.tables();
    auto rules = stem_rules(model.pattern, Stems::Composed, sizes, &tables);
    replace_all(rules, "<leaves>", surface_rules(model.organs, model.first_surface, "z"));
    rules = with_own_names(rules, number);
    if (model.offset == 0)
        replace_all(rules, "<offset> + ", "");
    replace_all(rules, "<offset>", std::to_string(model.offset));
    replace_all(rules, "<calls>", calls_text(models, number));
    replace_all(rules, "~l(", fmt::format("~{}(", letter_of(number)));
    auto arrays = arrays_of(model.construction);
    auto const of_layers = arrays_of(tables);
    arrays.insert(arrays.end(), of_layers.begin(), of_layers.end());
    return fmt::format("Lsystem: {}\n"
                       "derivation length: {}\n"
                       "define: {{ {}; }}\n"
                       "Axiom: +(func({}, 0))^(func({}, 0))A(0, 0, 0, 0)\n\n"
                       "{}endlsystem\n",
                       number + 1, model.steps, fmt::join(arrays, ";\n          "),
                       model.offset + 1, model.offset + 2, rules);
}

} // namespace

// Writes the model of several stems whose layers bear leaves and surfaces.
static Result<LineModel> write_several(ComposedSketch const& sketch, std::string const& name)
{
    for (auto const& organ : sketch.organs)
        if (organ.sketch)
            return fail(Fault::User,
                        "a sketch with organs that are sketches has one stem: leave the others "
                        "out");
    for (auto const& stem : sketch.stems)
        for (auto const& layer : stem.construction.organs_per_layer)
            CHECK(layer.organ <= sketch.organs.size());
    auto model = write_model(sketch.stems, sketch.pattern, name);
    replace_all(model.source.text, "<leaves>", surface_rules(sketch.organs, 0, "s, z"));
    TRY(add_surfaces(model, sketch.organs, 0));
    return model;
}

static std::string heading_text(std::size_t count)
{
    auto const of_organs = count == 1
        ? std::string("/* A plant of construction lines, whose layers may bear different organs: "
                      "tables say of each\n   layer which organ it bears, 0 leaves, in which "
                      "pattern, and how far it is rolled. ")
        : fmt::format("/* A plant of {} sketches of construction lines: organs of one are plants "
                      "of another, which is an\n   L-system that it calls. ",
                      count);
    return of_organs
        + "The functions of the place x on a stem, 0 to 1, are files that the view\n"
          "   names, for each sketch: its stem's heading and depth, the organs' angles on the left "
          "and the\n"
          "   right, their sizes there, and, for other models, the way to the next node. A step "
          "makes a node. */\n";
}

static bool is_plain(ComposedSketch const& sketch)
{
    return std::all_of(sketch.stems.begin(), sketch.stems.end(), [](MeasuredStem const& stem) {
        return stem.construction.organs_per_layer.empty();
    });
}

// Adds the surfaces that replace leaves and organs in all sketches. They are numbered
// consecutively.
static Result<void> add_all_surfaces(LineModel& model, std::vector<SubModel> const& models)
{
    for (std::size_t i = 0; i < models.size(); ++i) {
        TRY(add_surfaces(model, models[i].organs, models[i].first_surface));
        if (!models[i].leaf.patches.empty())
            put_leaf(model, models[i].leaf, letter_of(i));
    }
    return {};
}

static Result<LineModel> write_single(ComposedSketch const& sketch, std::string const& name)
{
    std::vector<SubModel> models;
    TRY(add_sub_model(models, sketch));
    if (models.front().leaves > static_cast<double>(kMaxComposedLeaves))
        return fail(Fault::User,
                    fmt::format("the plant would have {:.0f} leaves, more than {}: give its layers "
                                "fewer nodes",
                                models.front().leaves, kMaxComposedLeaves));
    std::vector<std::pair<std::string, std::string>> functions;
    std::string definitions;
    std::string leaves;
    std::size_t surfaces = 0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        models[i].offset = functions.size();
        models[i].first_surface = surfaces;
        surfaces += count_surfaces(models[i].organs);
        for (auto const& curve : function_curves(models[i].construction))
            functions.emplace_back(models.size() == 1
                                       ? fmt::format("{}_{}.func", name, curve.name)
                                       : fmt::format("{}_{}_{}.func", name, i + 1, curve.name),
                                   function_file(curve));
        definitions += definitions_of(models[i], i);
        if (i > 0)
            leaves += leaf_statement(letter_of(i), models[i].pattern);
    }
    auto text = heading_text(models.size()) + definitions;
    for (std::size_t i = 0; i < models.size(); ++i)
        text.append("\n").append(system_text(models, i));
    auto model = model_with(std::move(text), functions, sketch.pattern, name);
    model.source.view_text += leaves;
    TRY(add_all_surfaces(model, models));
    return model;
}

Result<LineModel> write_composed_model(ComposedSketch const& sketch, std::string const& name)
{
    CHECK(!sketch.stems.empty());
    if (!is_plain(sketch) && sketch.stems.size() == 1)
        return write_single(sketch, name);
    auto model = is_plain(sketch) ? write_model(sketch.stems, sketch.pattern, name)
                                  : TRY(write_several(sketch, name));
    if (!sketch.leaf.patches.empty())
        put_leaf(model, sketch.leaf, letter_of(0));
    return model;
}

} // namespace tractus::lines
