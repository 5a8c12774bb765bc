#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"

#include <filesystem>
#include <vector>

namespace tractus::batch {

// Writes what a session consists of as files for other programs, and answers their names. Of a
// plant these are the rules (.l) and view (.v) of its model with what they include, also where a
// method has written the model; the lines (.obj) of its skeleton, or the file of its measured plant
// (.mtg, .csv, .txt, .ply); of any other its base plant as a graph (.mtg). Plants beside the first,
// and parts that were put on plants, have folders of their own, called after the plant and its id,
// and plants.txt says what stands where. strokes.txt (stroke_text.h) has the strokes that shape
// branches of the plant that takes what is drawn, if there are any.
//
// Each file appears whole or not at all. Fails, as the user's fault, for what is no session, and
// where a session of another's asks for files outside of the folder.
Result<std::vector<std::filesystem::path>> export_session(std::filesystem::path const& session,
                                                          std::filesystem::path const& folder,
                                                          scene::EditKinds kinds);

} // namespace tractus::batch
