#pragma once

#include "app/tools/least_extent.h"
#include "app/window/window.h"
#include "engine/base/result.h"

#include <filesystem>

namespace tractus::commands {

// The file that keeps how somebody wants the window to look: window.toml in user_folder(). Empty
// where the user has no home.
std::filesystem::path user_look_path();

// Reads such a file; the usual look where there is none. Fails, as the user's fault, naming the
// file, the line and what is wrong there.
Result<window::WindowLook> load_look(std::filesystem::path const& path);

// How far strokes have to get for tools, where the same file says so: its key "least", with words
// such as "draw=6 sketch=12" (tools/least_extent.h), which a person writes there. Empty where there
// is none. Fails like load_look().
Result<tools::LeastExtents> load_least_extents(std::filesystem::path const& path);

// Writes it, and its folder if that is not there. What the file says of least extents stays.
Result<void> save_look(std::filesystem::path const& path, window::WindowLook const& look);

} // namespace tractus::commands
