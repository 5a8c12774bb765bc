#include "app/methods/all_leaves.h"

#include "app/methods/all_inputs.h"
#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_picture.h"
#include "app/methods/leaves/plant_leaves.h"
#include "engine/base/fnv.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"

#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace tractus {

namespace {

namespace fs = std::filesystem;

// A word without what separates the parts of a sheet's name.
std::string word_of(std::string name)
{
    for (auto& letter : name)
        if (letter == ' ' || letter == '/')
            letter = '-';
    return name;
}

Result<std::string> sheet_of(std::string const& grammar_text, LeafOrder const& order)
{
    auto const grammar = TRY(leaf::parse_grammar(grammar_text, order.grammar));
    return print_leaf_sheet(TRY(grow_leaf_sheet(grammar, order)));
}

} // namespace

std::vector<LeafKind> leaf_kinds()
{
    std::vector<LeafKind> kinds;
    for (auto const& name : leaf_names())
        if (auto path = own_leaf_path(name))
            kinds.push_back({ name, *std::move(path) });
    return kinds;
}

std::string leaves_of_grammar(fs::path const& grammar)
{
    auto const name = grammar.stem().string();
    auto const ours = own_leaf_path(name);
    return ours && *ours == grammar ? name : grammar.string();
}

std::vector<DrawnLeafGrammar> drawn_leaves(DocumentState const& state)
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
    return read_leaf_text(path);
}

Result<std::vector<Edit>> dressing_edits(Scene const& scene, ItemId plant,
                                         std::string const& leaves)
{
    auto const number = TRY(plant_number(scene.state, plant));
    if (leaf::leaf_sketch(*scene.state.plants[number]))
        return fail(Fault::User,
                    "a drawn leaf wears no leaves itself: choose the plant that shall have them");
    if (leaves.empty())
        return std::vector<Edit> { DressPlant { plant, {} } };
    std::vector<Edit> edits;
    LeafOrder order { .grammar = leaves };
    if (fs::path(leaves).extension() == ".leaf") {
        auto const text = TRY(read_leaf_text(leaves));
        TRY(leaf::parse_grammar(text, leaves)); // With its line in the file, where it is wrong.
        order.grammar
            = fmt::format("{}-{:08x}.leaf", word_of(short_leaf_name(leaves)), fnv1a_32(text));
        edits.emplace_back(KeepGrammar { order.grammar, text });
        edits.emplace_back(KeepLeaves { leaf_sheet_name(order), TRY(sheet_of(text, order)) });
    } else if (!scene.state.leaf_sheets.contains(leaf_sheet_name(order))) {
        TRY(load_own_leaf_grammar(leaves)); // Lists ours, where it is none.
        edits.emplace_back(
            KeepLeaves { leaf_sheet_name(order), TRY(sheet_for(scene, leaf_sheet_name(order))) });
    }
    edits.emplace_back(DressPlant { plant, leaf_sheet_name(order) });
    return edits;
}

Result<std::string> sheet_for(Scene const& scene, std::string const& name)
{
    auto const order = parse_leaf_sheet_name(name);
    auto const& grammars = scene.state.leaf_grammars;
    auto const own = order ? grammars.find(order->grammar) : grammars.end();
    if (own != grammars.end())
        return sheet_of(*own->second, *order);
    if (auto made = TRY(make_input({}, name)))
        return *std::move(made);
    return fail(Fault::User, fmt::format("{} orders no leaves", name));
}

Result<Image> picture_of_grammar(fs::path const& grammar, int side, Color const& paper)
{
    auto const text = TRY(read_leaf_text(grammar));
    return picture_of_leaf(TRY(leaf::parse_grammar(text, grammar.string())), side, paper);
}

} // namespace tractus
