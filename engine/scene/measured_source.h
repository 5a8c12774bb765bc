#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

namespace tractus::scene {

// Builds the plant from the file contents in the edit, with the reader for their format: mtg.h,
// qsm.h or ply_skeleton.h. Fails like that reader, in a sentence that begins with the file's name.
Result<BuiltSource> build_measured(LoadMeasured const& measured, LoadOptions const& options);

} // namespace tractus::scene
