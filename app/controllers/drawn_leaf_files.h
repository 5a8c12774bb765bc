#pragma once

#include "engine/base/result.h"
#include "engine/scene/document_state.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::controllers {

// A file with the grammar of a leaf that was drawn in a document.
struct DrawnLeafFile {
    scene::ItemId leaf = 0; // The plant of the document that consists of this leaf.
    std::filesystem::path file {};

    bool operator==(DrawnLeafFile const&) const = default;
};

// Writes the grammars of leaves drawn in a document into a folder, one file per leaf in the order
// of the plants, for pages that show files. A leaf that cannot be written is skipped.
std::vector<DrawnLeafFile> write_drawn_leaves(scene::DocumentState const& state,
                                              std::filesystem::path const& folder);

// A file of leaves that were drawn in three views, and the plant that has them.
struct DrawnOrganFile {
    scene::ItemId plant = 0; // The plant that has the leaves.
    std::filesystem::path file {};
};

// Writes the leaves drawn in three views into a folder, like write_drawn_leaves().
std::vector<DrawnOrganFile> write_drawn_organs(scene::DocumentState const& state,
                                               std::filesystem::path const& folder);

// Writes a leaf's text, such as a grammar that only the document has, into the folder under this
// file name.
Result<std::filesystem::path> write_shown_leaf(std::string const& name, std::string const& text,
                                               std::filesystem::path const& folder);

// Saves a leaf's file in the user's own folder, which is created if necessary. Returns the saved
// file: an existing one with the same text, otherwise a new one of the same name, with a number
// appended if that is taken.
Result<std::filesystem::path> keep_leaf(std::filesystem::path const& leaf,
                                        std::filesystem::path const& folder);

} // namespace tractus::controllers
