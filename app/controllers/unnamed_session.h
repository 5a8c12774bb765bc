#pragma once

#include "engine/base/result.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace tractus::controllers {

// Generates a session's file name from the plant's name and the time, in the folder "tractus" of
// the user's data ($XDG_DATA_HOME, by default ~/.local/share, as in the XDG Base Directory
// Specification). Creates the folder if necessary, but not the file. Fails with a user error if the
// folder does not exist and cannot be created.
Result<std::filesystem::path> unnamed_session_path(std::string const& plant,
                                                   std::chrono::sys_seconds now);

// Deletes a session's file if nothing was ever drawn in it.
void remove_if_nothing_was_drawn(std::filesystem::path const& session);

} // namespace tractus::controllers
