#pragma once

#include "app/tools/tool_kind.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "sim/gesture_script.h"
#include "sim/hand.h"

#include <ostream>

namespace tractus::play {

// The hand that does what a script says, in its own time: where a recording's pen was in truth.
// Branches are traced as below. Fails, as the user's fault, naming the gesture, for a branch that
// the plant does not have, and for what the rig cannot reach.
Result<sim::Hand> simulated_hand(sim::GestureScript const& script, scene::Scene const& scene);

// Lets it do so on the simulated rig, and writes the log that a recording of it would have given:
// reports, tool changes and the rig's calibration. Branches that the script traces are those of the
// scene's base plant in drawing order (join_axes.h), from a little above where they leave their
// parent to a little below their tip. A pure function: the same script and plant give the same
// bytes.
//
// Fails, as the user's fault, naming the gesture, for a tool that is not among `tools` or has no
// such words (where there are none, no tool is looked at), for a branch that the plant does not
// have, and for what the rig cannot reach.
Result<void> write_simulated_recording(std::ostream& out, sim::GestureScript const& script,
                                       scene::Scene const& scene, tools::ToolKinds tools);

} // namespace tractus::play
