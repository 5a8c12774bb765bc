#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/organ_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::lines {

// File extension of leaves in three views.
constexpr char const* kOrganEnding = ".organ";

// Names of the built-in leaves in three views, in alphabetical order.
std::vector<std::string> organ_names();

// The file of a built-in leaf. Fails with a user error that lists the built-in leaves.
Result<std::filesystem::path> own_organ_path(std::string const& name);

// Loads a leaf's file. Fails with a user error if the file exceeds 1 MiB, and like parse_organ().
Result<OrganFile> load_organ(std::filesystem::path const& path);

// True if a name in a sketch's file refers to a leaf: to a .organ file relative to the sketch, or
// to a built-in leaf if no such file exists. Any other name refers to another sketch.
bool names_organ(std::string const& name, std::filesystem::path const& folder_of_sketch);

// Loads the leaf to which a name in a sketch's file refers. Fails like own_organ_path() and
// load_organ().
Result<OrganFile> load_named_organ(std::string const& name,
                                   std::filesystem::path const& folder_of_sketch);

} // namespace tractus::lines
