#pragma once

#include "app/tools/tool_kind.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "sim/gesture_script.h"
#include "sim/hand.h"

#include <ostream>

namespace tractus::play {

// Returns a simulated hand that performs a script, in its own time. It gives the true pen positions
// of a recording. Branches are traced as in write_simulated_recording(). Fails with a user error
// that names the gesture, for a branch that the plant lacks and for places out of the rig's reach.
Result<sim::Hand> simulated_hand(sim::GestureScript const& script, scene::Scene const& scene);

// Performs a script on the simulated rig and writes the log that a recording would contain:
// reports, tool changes and the rig's calibration. Branches that the script traces are those of the
// scene's base plant, in drawing order (join_axes.h), from just above their base to just below
// their tip. The same script and plant always give the same bytes. Fails with a user error that
// names the gesture, for an unknown tool or word (tools are not checked if `tools` is empty), for a
// branch that the plant lacks, and for places out of the rig's reach.
Result<void> write_simulated_recording(std::ostream& out, sim::GestureScript const& script,
                                       scene::Scene const& scene, tools::ToolKinds tools);

} // namespace tractus::play
