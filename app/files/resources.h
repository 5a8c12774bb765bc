#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::files {

// Finds a file or folder that comes with the program, such as "models/broadleaf.l" or "demo". Looks
// first where the program is installed (PREFIX/share/tractus beside PREFIX/bin, or beside
// PREFIX/lib with the Python module), then in the source tree from which it was built. Fails with a
// user error that names both places.
Result<std::filesystem::path> find_resource(std::string_view name);

// Returns the names of the files with this ending in one of the program's folders, without the
// ending, in alphabetical order. Empty if the folder is not installed.
std::vector<std::string> resource_names(std::string_view folder, std::string_view ending);

// Finds a model that the user named by the path of an existing file, or by the name of a built-in
// model ("shrub"). Fails with a user error that lists the built-in models.
Result<std::filesystem::path> find_model(std::string_view name);

// Like find_model(), but "empty" stands for an empty sheet, for which the path is empty.
Result<std::filesystem::path> find_plant(std::string_view name);

// Returns the names of the built-in models, in alphabetical order; empty if they are not installed.
std::vector<std::string> model_names();

} // namespace tractus::files
