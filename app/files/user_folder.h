#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <vector>

namespace tractus::files {

// Returns the folder of the program's data: $XDG_DATA_HOME/tractus, by default
// ~/.local/share/tractus (XDG Base Directory Specification). Empty if the user has no home folder.
std::filesystem::path user_folder();

// Returns the folder for files that can be generated again: $XDG_CACHE_HOME/tractus, by default
// ~/.cache/tractus. Empty if the user has no home folder. The folder may not exist yet.
std::filesystem::path user_cache_folder();

// Creates user_folder() if necessary and returns it. Fails with a user error if it cannot be
// created. The message ends with `instead`, which says what the user can do instead.
Result<std::filesystem::path> make_user_folder(std::string_view instead);

// Returns folders in which to look for the user's pictures, without duplicates: "pictures" in
// user_folder(), and the desktop's picture and download folders (from user-dirs.dirs of
// xdg-user-dirs, by default ~/Pictures and ~/Downloads). The folders may not exist.
std::vector<std::filesystem::path> user_picture_folders();

// Returns the path of the user's rig file, in which the window saves calibrations by default. Empty
// if the user has no home folder.
std::filesystem::path user_rig_path();

} // namespace tractus::files
