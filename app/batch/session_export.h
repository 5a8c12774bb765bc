#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"

#include <filesystem>
#include <vector>

namespace tractus::batch {

// Writes the contents of a session as files for other programs and returns their names. For a plant
// with a model, also one written by a method, these are its rules (.l) and view (.v) with the files
// they include; for a skeleton its lines (.obj); for a measured plant its file (.mtg, .csv, .txt,
// .ply); for any other its base plant as a graph (.mtg). Plants beside the first, and grafted
// parts, have folders of their own, named after the plant and its id; plants.txt lists where each
// plant stands and each part is attached. strokes.txt (stroke_text.h) contains the strokes that
// shape branches of the active plant, if there are any. Each file appears complete or not at all.
// Fails with a user error if the file is not a session, and if a foreign session asks for files
// outside the folder.
Result<std::vector<std::filesystem::path>> export_session(std::filesystem::path const& session,
                                                          std::filesystem::path const& folder,
                                                          scene::EditKinds kinds);

} // namespace tractus::batch
