#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::methods {

// What a model includes by name and a method makes, so that no file holds it: leaves that a view
// orders (leaf_sheet.h) are grown, from a grammar in the model's folder if the order names a .leaf,
// and else from one of ours. No value for names that no method knows, which are files' then.
//
// Fails, as the user's fault, with what the method says. The caller sees to it that `name` does not
// lead out of the folder.
Result<std::optional<std::string>> make_input(std::filesystem::path const& folder,
                                              std::string const& name);

} // namespace tractus::methods
