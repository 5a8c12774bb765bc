#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <functional>

namespace tractus::session {

// Makes the file of a session that appears whole: `write` writes it under another name beside it.
// Its folder is made, too. Fails, as the user's fault, if the file is there already or cannot be
// written; then nothing is left.
Result<void>
make_session_file(std::filesystem::path const& path,
                  std::function<Result<void>(std::filesystem::path const& made)> const& write);

} // namespace tractus::session
