#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <filesystem>
#include <optional>

namespace tractus::io {

// Reads a measured plant, or one saved by another program, as an edit that contains the whole file.
// The extension, in upper or lower case, shows whether it is one, and the content shows the format:
// .mtg (mtg.h), .csv or .txt (qsm.h), .ply (ply_skeleton.h). No value for other extensions, and for
// a .txt that is an L-system (contains "Lsystem:"). Fails with a user error that contains the
// file's name: like read_file() and the formats' readers, for text in UTF-16, for more than 64 MB,
// and for files that must be converted first: scanned points (.las, .laz, .e57, .pcd, .pts, .xyz)
// and MATLAB files (.mat).
Result<std::optional<scene::LoadMeasured>> load_measured_edit(std::filesystem::path const& path);

} // namespace tractus::io
