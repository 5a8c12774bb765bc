#pragma once

#include "app/tools/gizmo.h"
#include "engine/methods/sketch_lsystem/model_rule.h"

namespace tractus::sketch {

// Picture of a model for the button of its preset: the plant that grows along a short stroke, with
// the axis along the stroke in a dark colour. It has no handles. Pictures are cached by the model's
// name.
tools::Gizmo show_model(sketch::ModelRule const& model);

} // namespace tractus::sketch
