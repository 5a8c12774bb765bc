#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>

namespace tractus {

// The whole file as bytes. Fails, as the user's fault, if it cannot be opened or read, or if it is
// larger than `max_bytes`.
Result<std::string> read_file(std::filesystem::path const& path,
                              std::size_t max_bytes = std::size_t { 1 } << 30);

// Makes a folder and those that it is in, where they are not there. Fails, as the user's fault.
Result<void> make_folder(std::filesystem::path const& folder);

// Calls `write` with a stream to a temporary file beside `path`, then renames it to `path`, so that
// under its final name the file is always whole: the old one or the new one. When `write` or the
// disk fails, the temporary file is removed, the old file stays, and the error says why.
// The stream is seekable and binary. A symbolic link stays, and what it points to is written. What
// is not a file (/dev/stdout, a pipe) is written straight away, and need not be seekable.
Result<void> write_file(std::filesystem::path const& path,
                        std::function<Result<void>(std::ostream&)> const& write);

// From now on a signal that ends the program (Ctrl-C, SIGTERM, SIGHUP) first removes the temporary
// file of a write_file() under way. For main(). Signals that are ignored stay so.
void remove_unfinished_file_on_signals();

// The same for bytes at hand.
Result<void> write_file(std::filesystem::path const& path, std::string_view bytes);

} // namespace tractus
