#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus {

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
    ItemId plant = 0;
    std::string text;
};
std::vector<DrawnLeafGrammar> drawn_leaves(DocumentState const& state);

// The text of a grammar's file. Fails, as the user's fault, for one that is too long.
Result<std::string> read_leaf_grammar(std::filesystem::path const& path);

// The edits that give a plant of the scene other leaves, which are grown here: those of one of our
// species by its name alone, or of the grammar in a .leaf file; empty: the plant's own. Fails, as
// the user's fault, for a grammar that there is not or that gives no leaf, and for a plant that is
// a drawn leaf itself.
Result<std::vector<Edit>> dressing_edits(Scene const& scene, ItemId plant,
                                         std::string const& leaves);

// The text of the sheet of that name: from a grammar that the document keeps, else as make_input()
// has it. Fails, as the user's fault, where the name orders none.
Result<std::string> sheet_for(Scene const& scene, std::string const& name);

// A grown-up leaf of the grammar in a file, on paper, in a square of that side. Fails, as the
// user's fault, for a file that is none or gives no leaf.
Result<Image> picture_of_grammar(std::filesystem::path const& grammar, int side,
                                 Color const& paper);

} // namespace tractus
