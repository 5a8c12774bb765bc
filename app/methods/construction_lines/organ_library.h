#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/organ_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::lines {

// How files of leaves in three views end.
constexpr char const* kOrganEnding = ".organ";

// Leaves in three views that come with the program, in alphabetical order.
std::vector<std::string> organ_names();

// The file of one of ours. Fails, as the user's fault, listing them.
Result<std::filesystem::path> own_organ_path(std::string const& name);

// Fails, as the user's fault, for a file beyond 1 MiB, and like parse_organ().
Result<OrganFile> load_organ(std::filesystem::path const& path);

// Whether a name in a sketch's file is that of a leaf: of a file from where that one is, or of one
// of ours where there is no such file. Others are sketches.
bool names_organ(std::string const& name, std::filesystem::path const& folder_of_sketch);

// That leaf. Fails like the others.
Result<OrganFile> load_named_organ(std::string const& name,
                                   std::filesystem::path const& folder_of_sketch);

} // namespace tractus::lines
