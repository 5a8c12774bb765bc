#pragma once

#include "app/methods/leaves/leaf_study.h"
#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::methods {

// A leaf grammar that supplies the leaves of plants: a built-in one, named after its species, or
// the user's own .leaf file.

struct LeafKind {
    std::string name;              // Name of the species, for example "tulip-tree".
    std::filesystem::path grammar; // Path of the grammar file.
};
std::vector<LeafKind> leaf_kinds(); // The built-in kinds of leaves, in alphabetical order.

// The name by which plants refer to leaves that are grown from a grammar file: the species' name
// for a built-in grammar, otherwise the file's path.
std::string leaves_of_grammar(std::filesystem::path const& grammar);

// A leaf drawn in the document, and the text of its grammar. Each drawn leaf is a plant of the
// document. If the lines of such a plant do not make a leaf yet, it is not listed.
struct DrawnLeafGrammar {
    scene::ItemId plant = 0;
    std::string text;
};
std::vector<DrawnLeafGrammar> drawn_leaves(scene::DocumentState const& state);

// Reads the text of a grammar file. Fails with a user error if the file is too long.
Result<std::string> read_leaf_grammar(std::filesystem::path const& path);

// A choice of leaves for a plant.
struct Foliage {
    // Name of a built-in species, path of a .leaf file, or name of a grammar stored in the
    // document. Empty: the plant's own leaves.
    std::string leaves {};
    // Id of a drawn leaf to use instead of `leaves`, or 0. The plant's leaves follow later changes
    // of the drawing.
    scene::ItemId drawn = 0;
    double age = 0.5; // Age of the leaves (LeafOrder): 0 is a bud, 1 a withered leaf.
    lsystem::LeafDamage damage {};
};

// Parses a choice of leaves as users write it: "oak", "oak+spots=0.3" (leaf_word.h) or "mine.leaf".
Foliage parse_foliage(std::string const& word);

// A leaf grammar's text, and the name by which the names of leaf sheets refer to the grammar.
struct GrammarOfLeaves {
    std::string name {};
    std::string text {};
};

// Finds the grammar of the chosen leaves. Fails with a user error if there is no such grammar, or
// if `foliage` selects the plant's own leaves.
Result<GrammarOfLeaves> grammar_of(scene::DocumentState const& state, Foliage const& foliage);

// Grows the chosen leaves and returns the edits that put them on a plant of the scene. Fails with a
// user error if the grammar does not exist or produces no leaf, or if the plant is itself a drawn
// leaf, which cannot have leaves.
Result<std::vector<scene::Edit>> foliage_edits(scene::Scene const& scene, scene::ItemId plant,
                                               Foliage const& foliage);

// The leaves that the user chose for the plant. No value if the plant has its own leaves or leaves
// of unknown origin. Foliage::drawn is set only while the drawn leaf is in the document; after the
// leaf has been removed, its grammar remains stored in the document.
std::optional<Foliage> chosen_foliage(scene::DocumentState const& state, scene::ItemId plant);

// Edits that must be made after a step that changes the drawing of a leaf that plants use. They
// store the leaf's new grammar under the same name and regrow these plants' leaves. Empty if the
// lines of the drawing no longer make a leaf, or the leaf was removed: plants then keep their
// present leaves.
std::vector<scene::Edit> dependent_leaf_edits(scene::Scene const& scene,
                                              std::vector<scene::Edit> const& step);

// Returns the text of the leaf sheet with this name. The sheet is made from a grammar stored in the
// document if there is one, otherwise by make_input(). Fails with a user error if `name` is not the
// name of a leaf sheet.
Result<std::string> sheet_for(scene::Scene const& scene, std::string const& name);

// Renders a leaf of a grammar on paper, with the leaf's maps and more leaves of the grammar
// (study_leaf()). Fails with a user error if the text is not a grammar or produces no leaf.
Result<leaf::LeafStudy> study_of_grammar(std::string const& text, std::string const& name,
                                         leaf::LeafLook const& look, render::Color const& paper);

// Renders an adult leaf of a grammar file on paper, in a square image of `side` pixels. Fails with
// a user error if the file is not a grammar or produces no leaf.
Result<render::Image> picture_of_grammar(std::filesystem::path const& grammar, int side,
                                         render::Color const& paper);

} // namespace tractus::methods
