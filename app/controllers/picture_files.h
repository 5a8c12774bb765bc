#pragma once

#include "engine/base/result.h"
#include "engine/scene/back_picture.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace tractus::controllers {

// True if the file's extension is that of a picture.
bool is_picture_file(std::filesystem::path const& file);

// Returns the pictures in a folder and its subfolders, newest first, at most `most`. Hidden files
// are skipped. The result is empty if `folder` is not a folder.
std::vector<std::filesystem::path> pictures_in(std::filesystem::path const& folder,
                                               std::size_t most);

// Reads a picture to lay behind the drawing, scaled to fit a tablet of this size with some margin.
// Fails with a user error, which names the file, if the picture cannot be read or decoded or is
// larger than a drawing may store.
Result<scene::LayPicture> load_back_picture(std::filesystem::path const& file,
                                            Vec2 const& tablet_mm);

} // namespace tractus::controllers
