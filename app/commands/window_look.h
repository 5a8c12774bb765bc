#pragma once

#include "app/tools/min_extent.h"
#include "app/window/window.h"
#include "engine/base/result.h"

#include <filesystem>

namespace tractus::commands {

// Path of the file with the user's window settings: window.toml in user_folder(). Empty if the user
// has no home folder.
std::filesystem::path user_look_path();

// Reads the settings; defaults if there is no file. Fails with a user error that names the file,
// the line and the problem.
Result<window::WindowLook> load_look(std::filesystem::path const& path);

// Reads the least extents of strokes from the same file: its key "least", with words such as
// "draw=6 sketch=12" (tools/min_extent.h), is edited by the user. Empty if the key is missing.
// Fails like load_look().
Result<tools::MinExtents> load_min_extents(std::filesystem::path const& path);

// Writes the settings, and creates the folder if necessary. The file's least extents are kept.
Result<void> save_look(std::filesystem::path const& path, window::WindowLook const& look);

} // namespace tractus::commands
