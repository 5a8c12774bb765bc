#pragma once

#include "app/tools/min_extent.h"
#include "app/window/window.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::commands {

// Path of the file with the user's window settings: window.toml in user_folder(). Empty if the user
// has no home folder.
std::filesystem::path user_look_path();

// Reads the window settings; returns the defaults if the file is missing. Fails with a user error
// that names the file, the line and the problem.
Result<window::WindowLook> load_look(std::filesystem::path const& path);

// Parses the text of the window settings' file. `name` is the file's name, for messages.
Result<window::WindowLook> parse_look(std::string_view text, std::string const& name);

// Reads the minimum extents of strokes from the window settings' file. The user may write them
// there, as the key "least" with a text such as "draw=6 sketch=12" (tools/min_extent.h). Empty if
// the key is missing. Fails like load_look().
Result<tools::MinExtents> load_min_extents(std::filesystem::path const& path);
Result<tools::MinExtents> parse_look_extents(std::string_view text, std::string const& name);

// Returns the text of the window settings' file.
std::string print_look(window::WindowLook const& look, tools::MinExtents const& least);

// Writes the window settings and creates their folder if necessary. The key "least" is kept.
Result<void> save_look(std::filesystem::path const& path, window::WindowLook const& look);

} // namespace tractus::commands
