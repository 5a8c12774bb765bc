#pragma once

#include "engine/base/result.h"
#include "engine/scene/document_state.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::controllers {

// Writes the grammars of the leaves that are drawn in a document below a folder, for pages that
// show files: one for each leaf, in the order of the plants. One that cannot be written is left
// out.
struct DrawnLeafFile {
    scene::ItemId leaf = 0; // The plant that is the leaf.
    std::filesystem::path file {};

    bool operator==(DrawnLeafFile const&) const = default;
};
std::vector<DrawnLeafFile> write_drawn_leaves(scene::DocumentState const& state,
                                              std::filesystem::path const& folder);

// Writes the leaves that are drawn in three views for plants of a document there likewise.
struct DrawnOrganFile {
    scene::ItemId plant = 0; // Which bears it.
    std::filesystem::path file {};
};
std::vector<DrawnOrganFile> write_drawn_organs(scene::DocumentState const& state,
                                               std::filesystem::path const& folder);

// Writes the text of a leaf of this file name there likewise, such as a grammar that only the
// document has.
Result<std::filesystem::path> write_shown_leaf(std::string const& name, std::string const& text,
                                               std::filesystem::path const& folder);

// Keeps a leaf's file among a person's own, in a folder that is made if it is not there. Returns
// its file: one that has this text already, else a new one, called like it or with a number behind.
Result<std::filesystem::path> keep_leaf(std::filesystem::path const& leaf,
                                        std::filesystem::path const& folder);

} // namespace tractus::controllers
