#pragma once

#include "app/tools/glyph.h"
#include "engine/methods/sketch_lsystem/model_rule.h"

namespace tractus::sketch {

// A model that grows along a stroke as a card shows it: the plant of a short stroke, its axis dark.
// It has no handles. Grown once, and kept.
tools::Glyph show_model(sketch::ModelRule const& model);

} // namespace tractus::sketch
