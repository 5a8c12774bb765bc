#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"

#include <filesystem>
#include <vector>

namespace tractus {

// Writes what a session consists of as files for other programs, and answers their names: the rules
// (.l) and view (.v) of its model with what they include, the lines (.obj) of its skeleton or the
// file of its measured plant (.mtg, .csv, .txt, .ply); and strokes.txt (stroke_text.h) where
// strokes shape branches. Each file appears whole or not at all. Fails, as the user's fault, for
// what is no session, and where a session of another's asks for files outside of the folder.
Result<std::vector<std::filesystem::path>> export_session(std::filesystem::path const& session,
                                                          std::filesystem::path const& folder,
                                                          EditKinds kinds);

} // namespace tractus
