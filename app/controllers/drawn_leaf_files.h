#pragma once

#include "engine/base/result.h"
#include "engine/scene/document_state.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::controllers {

// A file with the grammar of a leaf drawn in a document.
struct DrawnLeafFile {
    scene::ItemId leaf = 0; // Id of the plant that consists of this leaf.
    std::filesystem::path file {};

    bool operator==(DrawnLeafFile const&) const = default;
};

// Writes the grammars of leaves drawn in a document into a folder, so that a page of files can show
// them: one file per leaf, in the order of the plants. A leaf that cannot be written is skipped.
std::vector<DrawnLeafFile> write_drawn_leaves(scene::DocumentState const& state,
                                              std::filesystem::path const& folder);

// A file of leaves drawn in three views, with the plant that carries them.
struct DrawnOrganFile {
    scene::ItemId plant = 0; // Id of the plant that carries the leaves.
    std::filesystem::path file {};
};

// Writes the leaves drawn in three views into a folder, as write_drawn_leaves() writes grammars.
std::vector<DrawnOrganFile> write_drawn_organs(scene::DocumentState const& state,
                                               std::filesystem::path const& folder);

// Writes the text of a leaf, such as a grammar that exists only in the document, into the folder
// under this file name. Returns the file's path.
Result<std::filesystem::path> write_shown_leaf(std::string const& name, std::string const& text,
                                               std::filesystem::path const& folder);

// Saves a leaf's file in `folder`, the user's own, which is created if necessary. Returns the path
// of the saved file. An existing file with the same text is used again; otherwise a new file gets
// the same name, with a number appended if that name is already used.
Result<std::filesystem::path> keep_leaf(std::filesystem::path const& leaf,
                                        std::filesystem::path const& folder);

} // namespace tractus::controllers
