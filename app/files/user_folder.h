#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <vector>

namespace tractus::files {

// Where the program keeps what a person did not name: $XDG_DATA_HOME/tractus, else
// ~/.local/share/tractus (XDG Base Directory Specification). Empty where the user has no home.
std::filesystem::path user_folder();

// Where what can be made again is kept meanwhile: $XDG_CACHE_HOME/tractus, else ~/.cache/tractus.
// Empty where the user has no home. The folder need not be there.
std::filesystem::path user_cache_folder();

// Makes user_folder() if it is not there, and returns it. Fails, as the user's fault, if it cannot
// be made; the sentence ends in what to do: `instead`.
Result<std::filesystem::path> make_user_folder(std::string_view instead);

// Where a person's pictures are, each once: "pictures" in user_folder(), and the desktop's folders
// for pictures and for what was downloaded (user-dirs.dirs of xdg-user-dirs, else ~/Pictures and
// ~/Downloads). They need not be there.
std::vector<std::filesystem::path> user_picture_folders();

// The calibration of the table that belongs to this user, where the window keeps it unless it is
// told another place. Empty where the user has no home.
std::filesystem::path user_rig_path();

} // namespace tractus::files
