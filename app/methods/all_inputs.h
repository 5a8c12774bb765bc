#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::methods {

// Generates the text of a file that a model includes by name although no such file exists. At
// present these are leaf sheets ordered by an L-system view (leaf_sheet.h). Their leaves are grown
// from a .leaf grammar in the model's folder `folder` if `name` contains one, otherwise from a
// built-in grammar. Returns no value for any other name; the caller then looks for a file. Fails
// with a user error if the leaves cannot be grown. The caller must make sure that `name` does not
// lead out of `folder`.
Result<std::optional<std::string>> make_input(std::filesystem::path const& folder,
                                              std::string const& name);

} // namespace tractus::methods
