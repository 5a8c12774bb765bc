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

// Writes a grammar there likewise, such as one that only the document has.
Result<std::filesystem::path> write_shown_leaf(std::string const& name, std::string const& grammar,
                                               std::filesystem::path const& folder);

// Keeps a grammar among a person's own, in a folder that is made if it is not there. Returns its
// file: one that has this text already, else a new one, called like it or with a number behind.
Result<std::filesystem::path> keep_leaf(std::filesystem::path const& grammar,
                                        std::filesystem::path const& folder);

} // namespace tractus::controllers
