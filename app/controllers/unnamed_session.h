#pragma once

#include "engine/base/result.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace tractus::controllers {

// Where a drawing is kept that nobody has named: a new session named after the plant and the time,
// in the folder "tractus" of the user's data ($XDG_DATA_HOME, else ~/.local/share, as the XDG Base
// Directory Specification has it), which is made if it is not there. The file is not made.
//
// Fails, as the user's fault, where the user has no such folder and it cannot be made.
Result<std::filesystem::path> unnamed_session_path(std::string const& plant,
                                                   std::chrono::sys_seconds now);

// Takes a session's file away again if nothing was ever drawn in it.
void remove_if_nothing_was_drawn(std::filesystem::path const& session);

} // namespace tractus::controllers
