#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

namespace tractus::scene {

// Reads the file that the edit holds, in its format: mtg.h, qsm.h or ply_skeleton.h. Fails as that
// reader does, in a sentence that begins with the file's name.
Result<BuiltSource> build_measured(LoadMeasured const& measured, LoadOptions const& options);

} // namespace tractus::scene
