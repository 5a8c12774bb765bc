#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::files {

// A file or folder that comes with the program: "models/broadleaf.l", "demo". Looked for where the
// program is installed (PREFIX/share/tractus beside PREFIX/bin), then in the source tree it was
// built from. Fails, as the user's fault, naming both places.
Result<std::filesystem::path> find_resource(std::string_view name);

// The names, without this ending, of the files in one of the program's folders, in alphabetical
// order; none where that is not installed.
std::vector<std::string> resource_names(std::string_view folder, std::string_view ending);

// A model that the user named: a file as it is, or else one of ours by its name alone ("shrub").
// Fails, as the user's fault, listing ours.
Result<std::filesystem::path> find_model(std::string_view name);

// Does as find_model(), but that "empty" is an empty sheet, whose path is empty.
Result<std::filesystem::path> find_plant(std::string_view name);

// The names of ours, in alphabetical order; none where they are not installed.
std::vector<std::string> model_names();

} // namespace tractus::files
