#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::methods {

// Generates the text of a file that a model includes by name although no such file exists. So far
// these are leaf sheets ordered by an L-system view (leaf_sheet.h): their leaves are grown from the
// .leaf grammar in the model's folder if the name contains one, otherwise from a built-in grammar.
// Returns no value for any other name; the caller then looks for a file. Fails with a user error
// and the method's message. The caller must make sure that `name` does not lead out of `folder`.
Result<std::optional<std::string>> make_input(std::filesystem::path const& folder,
                                              std::string const& name);

} // namespace tractus::methods
