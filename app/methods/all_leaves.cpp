#include "app/methods/all_leaves.h"

#include "app/methods/all_inputs.h"
#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_picture.h"
#include "app/methods/leaves/plant_leaves.h"
#include "engine/base/fnv.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/scene/scene_builder.h"

#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace tractus::methods {

namespace {

namespace fs = std::filesystem;

// Replaces the characters that have a special meaning in the name of a leaf sheet.
std::string word_of(std::string name)
{
    for (auto& letter : name)
        if (letter == ' ' || letter == '/')
            letter = '-';
    return name;
}

// Returns the name of a drawn leaf's grammar. The name stays the same when the drawing changes, so
// that plants with this leaf can find the grammar.
std::string drawn_name(scene::ItemId leaf)
{
    return fmt::format("drawn-{:x}.leaf", leaf);
}

// Returns the drawn leaf for whose grammar drawn_name() gives this name; no value for any other
// name.
std::optional<scene::ItemId> drawn_leaf_of(std::string_view grammar)
{
    constexpr std::string_view kBegin = "drawn-";
    if (!grammar.starts_with(kBegin) || fs::path(grammar).extension() != ".leaf")
        return std::nullopt;
    scene::ItemId leaf = 0;
    auto const end = grammar.data() + grammar.size() - std::string_view(".leaf").size();
    auto const read = std::from_chars(grammar.data() + kBegin.size(), end, leaf, 16);
    if (read.ec != std::errc() || read.ptr != end || drawn_name(leaf) != grammar)
        return std::nullopt;
    return leaf;
}

// Makes the grammar of a leaf from its drawing. Fails if there is no plant with this id or its
// lines do not make a leaf.
Result<std::string> text_of_drawn(scene::DocumentState const& state, scene::ItemId leaf)
{
    auto const& plant = *state.plants[TRY(scene::plant_number(state, leaf))];
    auto const* const sketch = leaf::leaf_sketch(plant);
    if (!sketch)
        return fail(Fault::User, "the plant whose leaf is wanted is no drawn leaf");
    return leaf::grammar_text(*sketch, "Drawn by pen");
}

Result<std::string> sheet_of(std::string const& grammar_text, lsystem::LeafOrder const& order)
{
    auto const name = lsystem::parse_leaf_word(order.grammar).grammar;
    auto const grammar = TRY(leaf::parse_grammar(grammar_text, name));
    return lsystem::print_leaf_sheet(TRY(leaf::grow_leaf_sheet(grammar, order)));
}

// Edits that store a grammar in the document, and the leaf sheets with these names that are grown
// from it. What the document already has is not stored again.
Result<std::vector<scene::Edit>> keeping_edits(scene::DocumentState const& state,
                                               std::string const& grammar, std::string const& text,
                                               std::set<std::string> const& names)
{
    std::vector<scene::Edit> edits;
    auto const known = state.leaf_grammars.find(grammar);
    bool const is_known = known != state.leaf_grammars.end() && *known->second == text;
    if (!is_known)
        edits.emplace_back(scene::KeepGrammar { grammar, text });
    for (auto const& name : names)
        if (!is_known || !state.leaf_sheets.contains(name))
            edits.emplace_back(scene::KeepLeaves {
                name, TRY(sheet_of(text, *lsystem::parse_leaf_sheet_name(name))) });
    return edits;
}

// For each drawn leaf, the names of the leaf sheets grown from it that plants use.
std::map<scene::ItemId, std::set<std::string>> drawn_and_worn(scene::DocumentState const& state)
{
    std::map<scene::ItemId, std::set<std::string>> worn;
    for (auto const& plant : state.plants) {
        auto const order = lsystem::parse_leaf_sheet_name(plant->leaves);
        auto const grammar
            = order ? lsystem::parse_leaf_word(order->grammar).grammar : std::string();
        if (auto const leaf = drawn_leaf_of(grammar); leaf && scene::find_plant(state, *leaf))
            worn[*leaf].insert(plant->leaves);
    }
    return worn;
}

} // namespace

std::vector<LeafKind> leaf_kinds()
{
    std::vector<LeafKind> kinds;
    for (auto const& name : leaf::leaf_names())
        if (auto path = leaf::own_leaf_path(name))
            kinds.push_back({ name, *std::move(path) });
    return kinds;
}

std::string leaves_of_grammar(fs::path const& grammar)
{
    auto const name = grammar.stem().string();
    auto const ours = leaf::own_leaf_path(name);
    return ours && *ours == grammar ? name : grammar.string();
}

std::vector<DrawnLeafGrammar> drawn_leaves(scene::DocumentState const& state)
{
    std::vector<DrawnLeafGrammar> leaves;
    for (auto const& plant : state.plants)
        if (auto const* const sketch = leaf::leaf_sketch(*plant))
            if (auto text = leaf::grammar_text(*sketch, "Drawn by pen"))
                leaves.push_back({ plant->id, *std::move(text) });
    return leaves;
}

Result<std::string> read_leaf_grammar(fs::path const& path)
{
    return leaf::read_leaf_text(path);
}

Foliage parse_foliage(std::string const& word)
{
    auto [grammar, damage] = lsystem::parse_leaf_word(word);
    return { .leaves = std::move(grammar), .damage = damage };
}

Result<GrammarOfLeaves> grammar_of(scene::DocumentState const& state, Foliage const& foliage)
{
    auto const& leaves = foliage.leaves;
    if (foliage.drawn != 0)
        return GrammarOfLeaves { drawn_name(foliage.drawn),
                                 TRY(text_of_drawn(state, foliage.drawn)) };
    if (auto const kept = state.leaf_grammars.find(leaves); kept != state.leaf_grammars.end())
        return GrammarOfLeaves { leaves, *kept->second };
    if (fs::path(leaves).extension() != ".leaf") {
        // If there is no leaf of this name, the error lists the built-in grammars.
        auto const file = TRY(leaf::own_leaf_path(leaves));
        return GrammarOfLeaves { leaves, TRY(leaf::read_leaf_text(file)) };
    }
    auto text = TRY(leaf::read_leaf_text(leaves));
    // Parsed already here, so that an error names the line in the file.
    TRY(leaf::parse_grammar(text, leaves));
    auto name
        = fmt::format("{}-{:08x}.leaf", word_of(leaf::short_leaf_name(leaves)), fnv1a_32(text));
    return GrammarOfLeaves { std::move(name), std::move(text) };
}

Result<std::vector<scene::Edit>> foliage_edits(scene::Scene const& scene, scene::ItemId plant,
                                               Foliage const& foliage)
{
    auto const number = TRY(scene::plant_number(scene.state, plant));
    if (leaf::leaf_sketch(*scene.state.plants[number]))
        return fail(Fault::User,
                    "a drawn leaf wears no leaves itself: choose the plant that shall have them");
    if (foliage.leaves.empty() && foliage.drawn == 0)
        return std::vector<scene::Edit> { scene::SetFoliage { plant, {} } };
    auto const [name, text] = TRY(grammar_of(scene.state, foliage));
    lsystem::LeafOrder const order { .grammar = lsystem::leaf_word({ name, foliage.damage }),
                                     .age = foliage.age };
    auto const sheet = lsystem::leaf_sheet_name(order);
    std::vector<scene::Edit> edits;
    if (fs::path(name).extension() == ".leaf") {
        std::set<std::string> names { sheet };
        if (foliage.drawn != 0)
            names.merge(drawn_and_worn(scene.state)[foliage.drawn]);
        edits = TRY(keeping_edits(scene.state, name, text, names));
    } else if (!scene.state.leaf_sheets.contains(sheet)) {
        edits.emplace_back(scene::KeepLeaves { sheet, TRY(sheet_for(scene, sheet)) });
    }
    edits.emplace_back(scene::SetFoliage { plant, sheet });
    return edits;
}

std::optional<Foliage> chosen_foliage(scene::DocumentState const& state, scene::ItemId plant)
{
    auto const number = scene::find_plant(state, plant);
    auto const order
        = number ? lsystem::parse_leaf_sheet_name(state.plants[*number]->leaves) : std::nullopt;
    if (!order)
        return std::nullopt;
    auto [grammar, damage] = lsystem::parse_leaf_word(order->grammar);
    Foliage worn { .age = order->age, .damage = damage };
    auto const drawn = drawn_leaf_of(grammar);
    if (drawn && text_of_drawn(state, *drawn))
        worn.drawn = *drawn;
    else
        worn.leaves = std::move(grammar);
    return worn;
}

std::vector<scene::Edit> dependent_leaf_edits(scene::Scene const& scene,
                                              std::vector<scene::Edit> const& step)
{
    std::vector<scene::Edit> edits;
    if (drawn_and_worn(scene.state).empty())
        return edits;
    scene::SceneBuilder builder(scene, {});
    auto const after = scene::apply_edits(scene.state, step, builder);
    if (!after)
        return edits; // The code that applies the step reports the error, so it is ignored here.
    for (auto const& [leaf, names] : drawn_and_worn(*after)) {
        auto const before = scene::find_plant(scene.state, leaf);
        auto const now = *scene::find_plant(*after, leaf);
        if (before && scene.state.plants[*before] == after->plants[now])
            continue; // The step did not change the drawing of this leaf.
        auto const text = text_of_drawn(*after, leaf);
        if (!text)
            continue;
        // If the grammar produces no leaf, plants keep their present leaves.
        if (auto const kept = keeping_edits(*after, drawn_name(leaf), *text, names))
            edits.insert(edits.end(), kept->begin(), kept->end());
    }
    return edits;
}

Result<std::string> sheet_for(scene::Scene const& scene, std::string const& name)
{
    auto const order = lsystem::parse_leaf_sheet_name(name);
    auto const& grammars = scene.state.leaf_grammars;
    auto const own
        = order ? grammars.find(lsystem::parse_leaf_word(order->grammar).grammar) : grammars.end();
    if (own != grammars.end())
        return sheet_of(*own->second, *order);
    if (auto made = TRY(make_input({}, name)))
        return *std::move(made);
    return fail(Fault::User, fmt::format("{} orders no leaves", name));
}

Result<leaf::LeafStudy> study_of_grammar(std::string const& text, std::string const& name,
                                         leaf::LeafLook const& look, render::Color const& paper)
{
    return leaf::study_leaf(TRY(leaf::parse_grammar(text, name)), look, paper);
}

Result<render::Image> picture_of_grammar(fs::path const& grammar, int side,
                                         render::Color const& paper)
{
    auto const text = TRY(leaf::read_leaf_text(grammar));
    return leaf::picture_of_leaf(TRY(leaf::parse_grammar(text, grammar.string())), side, paper);
}

} // namespace tractus::methods
