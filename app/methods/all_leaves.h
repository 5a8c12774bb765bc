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
    std::string name;              // For example "tulip-tree".
    std::filesystem::path grammar; // Path of the grammar file.
};
std::vector<LeafKind> leaf_kinds(); // The built-in kinds, in alphabetical order.

// Name by which plants refer to the leaves of a grammar file: the species' name for a built-in
// grammar, otherwise the path.
std::string leaves_of_grammar(std::filesystem::path const& grammar);

// A leaf drawn in the document, where each leaf is a plant of its own, and the text of its grammar.
// Plants whose lines do not make a leaf yet are not listed.
struct DrawnLeafGrammar {
    scene::ItemId plant = 0;
    std::string text;
};
std::vector<DrawnLeafGrammar> drawn_leaves(scene::DocumentState const& state);

// Reads the text of a grammar file. Fails with a user error if the file is too long.
Result<std::string> read_leaf_grammar(std::filesystem::path const& path);

// A choice of leaves for a plant.
struct Foliage {
    // A built-in species' name, a path of a .leaf file, or the name of a grammar stored in the
    // document. Empty: the plant's own leaves.
    std::string leaves {};
    // If not 0, id of a drawn leaf to use instead of `leaves`; the plant follows later changes of
    // the drawing.
    scene::ItemId drawn = 0;
    double age = 0.5; // Age as in LeafOrder: 0 is a bud, 1 a withered leaf.
    lsystem::LeafDamage damage {};
};

// Parses a choice of leaves as users write it: "oak", "oak+spots=0.3" (leaf_word.h), "mine.leaf".
Foliage parse_foliage(std::string const& word);

// A leaf grammar, and its name as part of the names of leaf sheets.
struct GrammarOfLeaves {
    std::string name {};
    std::string text {};
};

// Finds the grammar of the chosen leaves. Fails with a user error if there is none, or if
// `foliage` selects the plant's own leaves.
Result<GrammarOfLeaves> grammar_of(scene::DocumentState const& state, Foliage const& foliage);

// Grows the leaves and returns the edits that put them on a plant of the scene. Fails with a user
// error if the grammar does not exist or produces no leaf, or if the plant is itself a drawn leaf,
// as a leaf cannot carry itself.
Result<std::vector<scene::Edit>> foliage_edits(scene::Scene const& scene, scene::ItemId plant,
                                               Foliage const& foliage);

// The leaves that the user chose for the plant, or no value if the plant has its own leaves or
// leaves of unknown origin. `drawn` is set only while the drawn leaf is in the document; when it is
// removed, its grammar stays stored in the document.
std::optional<Foliage> chosen_foliage(scene::DocumentState const& state, scene::ItemId plant);

// Edits that must follow a step that changes the drawing of a leaf, if plants use it: they store
// its new grammar under the same name and regrow those plants' leaves. Empty if the lines no longer
// make a leaf or the leaf was removed: plants then keep their present leaves.
std::vector<scene::Edit> dependent_leaf_edits(scene::Scene const& scene,
                                              std::vector<scene::Edit> const& step);

// Text of the leaf sheet with this name, from a grammar stored in the document if there is one,
// otherwise from make_input(). Fails with a user error if it is not the name of a leaf sheet.
Result<std::string> sheet_for(scene::Scene const& scene, std::string const& name);

// Renders a leaf of a grammar on paper, with its maps and more leaves of its kind; see
// study_leaf(). Fails with a user error if the text is not a grammar or produces no leaf.
Result<leaf::LeafStudy> study_of_grammar(std::string const& text, std::string const& name,
                                         leaf::LeafLook const& look, render::Color const& paper);

// Renders an adult leaf of a grammar file on paper, in a square image of `side` pixels. Fails with
// a user error if the file is not a grammar or produces no leaf.
Result<render::Image> picture_of_grammar(std::filesystem::path const& grammar, int side,
                                         render::Color const& paper);

} // namespace tractus::methods
