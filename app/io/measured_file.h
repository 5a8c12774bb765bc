#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <filesystem>
#include <optional>

namespace tractus::io {

// Reads a plant that was measured, or saved by another program, as an edit that contains the whole
// file. A file is such a plant if its extension, in upper or lower case, is .mtg (mtg.h), .csv or
// .txt (qsm.h), or .ply (ply_skeleton.h); its content determines the format. No value for other
// extensions, and for a .txt that is an L-system (contains "Lsystem:"). Fails with a user error
// that contains the file's name: like read_file() and the formats' readers, for text in UTF-16, for
// more than 64 MB, and for files that must be converted first. These are scanned points (.las,
// .laz, .e57, .pcd, .pts, .xyz) and MATLAB files (.mat).
Result<std::optional<scene::LoadMeasured>> load_measured_edit(std::filesystem::path const& path);

} // namespace tractus::io
