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

// Leaves that plants can wear, from grammars: those that come with the program, by the names of
// their species, and the user's own, by their files (.leaf).

struct LeafKind {
    std::string name;              // "tulip-tree".
    std::filesystem::path grammar; // Its file.
};
std::vector<LeafKind> leaf_kinds(); // Ours, in alphabetical order.

// What a grammar is called as leaves to wear: by its species' name if it is one of ours.
std::string leaves_of_grammar(std::filesystem::path const& grammar);

// The leaves that are drawn in a document, each a plant of it, and their grammars. One whose lines
// are no leaf yet is none.
struct DrawnLeafGrammar {
    scene::ItemId plant = 0;
    std::string text;
};
std::vector<DrawnLeafGrammar> drawn_leaves(scene::DocumentState const& state);

// The text of a grammar's file. Fails, as the user's fault, for one that is too long.
Result<std::string> read_leaf_grammar(std::filesystem::path const& path);

// Which leaves a plant is to have.
struct Dressing {
    // One of our species by its name alone, the grammar in a .leaf file, or one that the document
    // keeps, by its name there; empty: the plant's own.
    std::string leaves {};
    scene::ItemId drawn
        = 0;          // In place of them: those of a drawn leaf, which they follow from then on.
    double age = 0.5; // As of LeafOrder.
    lsystem::LeafDamage damage {};
};

// As people write it: "oak", "oak+spots=0.3" (leaf_word.h), "mine.leaf".
Dressing dressing_of_word(std::string const& word);

// The grammar of these leaves, and what it is called in the names of their sheets. Fails, as the
// user's fault, where there is none, and for the plant's own.
struct GrammarOfLeaves {
    std::string name {};
    std::string text {};
};
Result<GrammarOfLeaves> grammar_of(scene::DocumentState const& state, Dressing const& dressing);

// The edits that give a plant of the scene such leaves, which are grown here. Fails, as the user's
// fault, for a grammar that there is not or that gives no leaf, and for a plant that is a drawn
// leaf itself: so no leaf can come to wear itself.
Result<std::vector<scene::Edit>> dressing_edits(scene::Scene const& scene, scene::ItemId plant,
                                                Dressing const& dressing);

// What a plant wears, as it was asked for; no value: its own leaves, or some that nothing is known
// of. Those of a leaf that was drawn in the document are `drawn` as long as that is there, and
// after that they are among what the document keeps.
std::optional<Dressing> worn_leaves(scene::DocumentState const& state, scene::ItemId plant);

// The edits that a step brings with it where it changes the drawing of a leaf that plants wear: its
// grammar under its own name, and the leaves of it that are worn, as they would be were they put on
// again. None where the lines are no leaf any more, or the leaf is gone: the plants keep what they
// have.
std::vector<scene::Edit> leaves_that_follow(scene::Scene const& scene,
                                            std::vector<scene::Edit> const& step);

// The text of the sheet of that name: from a grammar that the document keeps, else as make_input()
// has it. Fails, as the user's fault, where the name orders none.
Result<std::string> sheet_for(scene::Scene const& scene, std::string const& name);

// A leaf of a grammar's text on paper, with its maps and others of its kind: see study_leaf().
// Fails, as the user's fault, for a text that is none or gives no leaf.
Result<leaf::LeafStudy> study_of_grammar(std::string const& text, std::string const& name,
                                         leaf::LeafLook const& look, render::Color const& paper);

// A grown-up leaf of the grammar in a file, on paper, in a square of that side. Fails, as the
// user's fault, for a file that is none or gives no leaf.
Result<render::Image> picture_of_grammar(std::filesystem::path const& grammar, int side,
                                         render::Color const& paper);

} // namespace tractus::methods
