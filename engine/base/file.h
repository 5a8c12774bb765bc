#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace tractus {

// The whole file as bytes. Fails, as the user's fault, if it cannot be opened or read, or if it is
// larger than `max_bytes`.
Result<std::string> read_file(std::filesystem::path const& path,
                              std::size_t max_bytes = std::size_t { 1 } << 30);

// Reads a text in UTF-8 or ASCII. Fails like read_file(), and, as the user's fault, for one in
// UTF-16 or UTF-32, which other systems' editors write.
Result<std::string> read_text_file(std::filesystem::path const& path,
                                   std::size_t max_bytes = std::size_t { 1 } << 30);

// Refuses, as the user's fault, bytes that begin as UTF-16 or UTF-32 text does. `name` is the
// file's.
Result<void> refuse_wide_text(std::string_view bytes, std::string_view name);

// Gives a file's bytes piece by piece, in their order, so that nobody needs room for all of them.
// Fails like read_file(), or as soon as `take` does.
Result<void> read_file_in_pieces(std::filesystem::path const& path, std::size_t max_bytes,
                                 std::function<Result<void>(std::string_view piece)> const& take);

// Makes a folder and those that it is in, where they are not there. Fails, as the user's fault.
Result<void> make_folder(std::filesystem::path const& folder);

// Whether write_file() may write there, for callers that want to know before long work: the folder
// that the file is to be in, or the nearest that is there above it, takes new files. Changes
// nothing. Fails, as the user's fault.
Result<void> check_writable(std::filesystem::path const& path);

// Calls `write` with a stream to a temporary file beside `path`, lets the disk take it, then
// renames it to `path`, so that under its final name the file is always whole: the old one or the
// new one, also after the power has failed. Folders that are not there are made. When `write` or
// the disk fails, the temporary file is removed, the old file stays, and the error says why. The
// stream is seekable and binary. A symbolic link stays, and what it points to is written. What is
// not a file (/dev/stdout, a pipe) is written straight away, and need not be seekable.
Result<void> write_file(std::filesystem::path const& path,
                        std::function<Result<void>(std::ostream&)> const& write);

// Lets the disk take a file's new name, and the one that is gone, of a rename. A folder that cannot
// be flushed, as on some file systems, is no error.
void flush_name_to_disk(std::filesystem::path const& path);

// Lets the disk take what was written to a file, then gives it another name, or writes over the
// file that has it, and lets the disk take that. Fails, as the user's fault, and leaves both as
// they are.
Result<void> rename_on_disk(std::filesystem::path const& from, std::filesystem::path const& to);

// Makes a signal that ends the program (Ctrl-C, SIGTERM, SIGHUP) first remove the temporary files
// of each write_file() under way, in all threads. For main(). Signals that are ignored stay so.
void remove_unfinished_file_on_signals();

// Writes bytes at hand in the same way.
Result<void> write_file(std::filesystem::path const& path, std::string_view bytes);

} // namespace tractus
