#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace tractus {

// Returns the whole file as bytes. Fails with a user error if the file cannot be opened or read or
// is larger than `max_bytes`.
Result<std::string> read_file(std::filesystem::path const& path,
                              std::size_t max_bytes = std::size_t { 1 } << 30);

// Reads a text file in UTF-8 or ASCII. Fails like read_file(), and with a user error if the text is
// in UTF-16 or UTF-32, as some editors save it.
Result<std::string> read_text_file(std::filesystem::path const& path,
                                   std::size_t max_bytes = std::size_t { 1 } << 30);

// Fails with a user error if the bytes begin like text in UTF-16 or UTF-32. `name` is the name of
// the file, for the message.
Result<void> refuse_wide_text(std::string_view bytes, std::string_view name);

// Passes the bytes of a file to `take` piece by piece, in order, so that the file is never in
// memory as a whole. Fails like read_file() or, as soon as `take` fails, with the error of `take`.
Result<void> read_file_in_pieces(std::filesystem::path const& path, std::size_t max_bytes,
                                 std::function<Result<void>(std::string_view piece)> const& take);

// Creates a folder and its missing parents. Fails with a user error if the system refuses.
Result<void> make_folder(std::filesystem::path const& folder);

// Checks whether write_file() could write to `path`, for callers that must know before they start
// long work. The file's folder, or the nearest existing folder above it, must accept new files.
// Changes nothing. Fails with a user error if the file could not be written.
Result<void> check_writable(std::filesystem::path const& path);

// Replaces the file at `path` atomically: calls `write` with a stream to a temporary file in the
// same folder, flushes that to the disk, then renames it to `path`. Under its final name the file
// is always complete, the old version or the new one, even after a power failure. Missing folders
// are created. If `write` or the disk fails, the temporary file is removed, the old file stays, and
// the error gives the reason. The stream is binary and seekable. A symbolic link is kept, and its
// target is replaced. A target that is not a regular file (/dev/stdout, a pipe) is written
// directly, and the stream need not be seekable.
Result<void> write_file(std::filesystem::path const& path,
                        std::function<Result<void>(std::ostream&)> const& write);

// Flushes the folder of `path` to the disk, so that a rename to `path` is not lost. A folder that
// cannot be flushed, as on some file systems, is not an error.
void flush_name_to_disk(std::filesystem::path const& path);

// Flushes the contents of the file `from` to the disk, renames it to `to`, replacing any file of
// that name, and flushes the rename. On failure returns a user error and leaves both files as they
// were.
Result<void> rename_on_disk(std::filesystem::path const& from, std::filesystem::path const& to);

// Installs handlers for the signals that end the program (Ctrl-C, SIGTERM, SIGHUP): the temporary
// files of every write_file() in progress, in all threads, are first removed. Call it from main().
// Signals that are ignored remain ignored.
void remove_unfinished_file_on_signals();

// Replaces the file at `path` by `bytes` atomically, like the other write_file().
Result<void> write_file(std::filesystem::path const& path, std::string_view bytes);

} // namespace tractus
