#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <vector>

namespace tractus::files {

// The program's data folder: $XDG_DATA_HOME/tractus, by default ~/.local/share/tractus (XDG Base
// Directory Specification). Empty if the user has no home folder.
std::filesystem::path user_folder();

// The folder for files that can be regenerated: $XDG_CACHE_HOME/tractus, by default
// ~/.cache/tractus. Empty if the user has no home folder. It may not exist yet.
std::filesystem::path user_cache_folder();

// Creates user_folder() if necessary and returns it. Fails with a user error if it cannot be
// created; the message ends with `instead`, which says what to do.
Result<std::filesystem::path> make_user_folder(std::string_view instead);

// Folders in which to look for the user's pictures, without duplicates: "pictures" in
// user_folder(), and the desktop's picture and download folders (from user-dirs.dirs of
// xdg-user-dirs, by default ~/Pictures and ~/Downloads). They may not exist.
std::vector<std::filesystem::path> user_picture_folders();

// The user's calibration of the moving table, where the window stores it by default. Empty if the
// user has no home folder.
std::filesystem::path user_rig_path();

} // namespace tractus::files
