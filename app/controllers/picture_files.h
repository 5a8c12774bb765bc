#pragma once

#include "engine/base/result.h"
#include "engine/scene/back_picture.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace tractus::controllers {

// By its name.
bool is_picture_file(std::filesystem::path const& file);

// The pictures in a folder and in its folders, the newest first, at most so many. Hidden ones are
// left out. None where it is no folder.
std::vector<std::filesystem::path> pictures_in(std::filesystem::path const& folder,
                                               std::size_t most);

// Reads a picture to be laid behind what is drawn, as large as fits on a tablet of that size with
// some air around it. Fails, as the user's fault, with the file's name, for one that cannot be read
// or shown, or that is larger than a drawing keeps.
Result<scene::LayPicture> load_back_picture(std::filesystem::path const& file,
                                            Vec2 const& tablet_mm);

} // namespace tractus::controllers
