#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>

namespace tractus::session {

// Returns what a person calls the session in a file; empty where it has no name, or cannot be read.
std::string session_name(std::filesystem::path const& path);

// Copies a session, in which this program or another may be drawing, to a new file, which appears
// whole, and gives the copy a name. Fails, as the user's fault, if that file is there already or
// cannot be written, and like the database.
Result<void> copy_session(std::filesystem::path const& path, std::filesystem::path const& copy,
                          std::string const& name);

} // namespace tractus::session
