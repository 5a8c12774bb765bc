#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/organ_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::lines {

// File extension of leaves drawn in three views.
constexpr char const* kOrganEnding = ".organ";

// Names of the built-in leaves drawn in three views, in alphabetical order.
std::vector<std::string> organ_names();

// The path of a built-in leaf's file. If there is no such leaf, fails with a user error that lists
// the built-in leaves.
Result<std::filesystem::path> own_organ_path(std::string const& name);

// Loads a leaf's file. Fails with a user error if the file cannot be read, exceeds 1 MiB or is
// invalid.
Result<OrganFile> load_organ(std::filesystem::path const& path);

// True if a name in a sketch's file refers to a leaf: it is the path, relative to the sketch, of a
// .organ file, or the name of a built-in leaf (no extension, and no such file exists). Any other
// name refers to another sketch.
bool names_organ(std::string const& name, std::filesystem::path const& folder_of_sketch);

// Loads the leaf to which a name in a sketch's file refers. Fails with a user error if there is no
// such leaf or its file is invalid.
Result<OrganFile> load_named_organ(std::string const& name,
                                   std::filesystem::path const& folder_of_sketch);

} // namespace tractus::lines
