#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::files {

// Finds a file or folder that comes with the program, such as "models/broadleaf.l" or "demo": first
// where the program is installed (PREFIX/share/tractus beside PREFIX/bin), then in the source tree
// that it was built from. Fails with a user error that names both places.
Result<std::filesystem::path> find_resource(std::string_view name);

// Names of the files in one of the program's folders that have this ending, without it, in
// alphabetical order; empty if the folder is not installed.
std::vector<std::string> resource_names(std::string_view folder, std::string_view ending);

// Finds a model that the user named: an existing file's path, or the name of a built-in model
// ("shrub"). Fails with a user error and a list of the built-in ones.
Result<std::filesystem::path> find_model(std::string_view name);

// Like find_model(), except that "empty" means an empty sheet, for which the path is empty.
Result<std::filesystem::path> find_plant(std::string_view name);

// Names of the built-in models, in alphabetical order; empty if they are not installed.
std::vector<std::string> model_names();

} // namespace tractus::files
