#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <functional>

namespace tractus::session {

// Creates a session's file atomically. `write` writes the file under the temporary name `made` in
// the same folder, which is created if necessary. Fails with a user error if the file exists or
// cannot be written; then no temporary file is left behind.
Result<void>
make_session_file(std::filesystem::path const& path,
                  std::function<Result<void>(std::filesystem::path const& made)> const& write);

} // namespace tractus::session
