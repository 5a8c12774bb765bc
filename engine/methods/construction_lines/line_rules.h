#pragma once

#include "engine/methods/construction_lines/layer_organs.h"
#include "engine/methods/construction_lines/pattern.h"

#include <string>

namespace tractus::lines {

// Kind of model: one stem; several stems, whose numbers are parameters of the modules; or one stem
// whose organs may be models of their own (composed_model.h).
enum class Stems { One, Several, Composed };

// Returns the rules of a model, for apex, stem and organs, which follow its axiom. They use the
// macros LEN, STEM, DX, ROLL and LAYERS, depending on the pattern also DIVERGENCE and WHORL, and
// the arrays `at` and `nodes`. Rules for several stems also use the arrays foot, bears, taper, low,
// own and organs (several_stem_model.cpp). If sizes follow half-ellipses, the rules also use the
// macro SIDES and the array azimuth or, for several stems, the arrays azimuth, sides and first.
//
// If layers have different organs, as in a composed model, Q(z, h) is an organ of relative size h
// in the layer with the index z in the layers' tables; for several stems it is Q(s, z, h). The
// caller must replace the placeholder <leaves> by homomorphism rules for organs that are not
// leaves; the rule for leaves, 0 in the array organ, is included. The arrays roll and pattern
// replace ROLL and the single pattern if `layers` has entries for them.
//
// In a composed model functions are numbered from <offset>, and the caller must replace <calls> by
// rules for organs that are models.
std::string stem_rules(Pattern const& pattern, Stems stems, Pattern::Sizes sizes,
                       LayerTables const* layers = nullptr);

} // namespace tractus::lines
