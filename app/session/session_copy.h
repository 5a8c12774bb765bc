#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>

namespace tractus::session {

// Returns the name that the user gave to the session in a file; empty if the session has no name or
// the file cannot be read.
std::string session_name(std::filesystem::path const& path);

// Copies a session to a new file, created atomically, and gives the copy a name. This program or
// another may be drawing in the original. Fails with a user error if the new file exists or cannot
// be written, or with a Database error.
Result<void> copy_session(std::filesystem::path const& path, std::filesystem::path const& copy,
                          std::string const& name);

} // namespace tractus::session
