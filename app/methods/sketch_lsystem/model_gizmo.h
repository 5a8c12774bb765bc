#pragma once

#include "app/tools/gizmo.h"
#include "engine/methods/sketch_lsystem/model_rule.h"

namespace tractus::sketch {

// Picture of a model for its preset's button: the plant that grows along a short stroke, its axis
// dark. It has no handles. Results are cached.
tools::Gizmo show_model(sketch::ModelRule const& model);

} // namespace tractus::sketch
