#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <filesystem>
#include <optional>

namespace tractus::io {

// Reads a plant that was measured, or that another program keeps, as an edit that holds all of its
// file. The ending says that it is one, whatever its case, and the content which: .mtg (mtg.h),
// .csv or .txt (qsm.h), .ply (ply_skeleton.h). No value for other endings, and for a .txt that is
// an L-system: that says Lsystem:.
//
// Fails, as the user's fault, in one sentence with the file's name: as read_file() and the readers
// of the formats do, for text in UTF-16, for more than 64 MB, and for what must become one of these
// formats first: points of a scanner (.las, .laz, .e57, .pcd, .pts, .xyz) and MATLAB's files
// (.mat).
Result<std::optional<scene::LoadMeasured>> load_measured_edit(std::filesystem::path const& path);

} // namespace tractus::io
