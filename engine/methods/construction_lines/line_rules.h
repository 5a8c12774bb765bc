#pragma once

#include "engine/methods/construction_lines/layer_organs.h"
#include "engine/methods/construction_lines/pattern.h"

#include <string>

namespace tractus::lines {

// Kind of model: one stem, several stems, whose numbers are then parameters of modules, or one stem
// with organs that may be models of their own (composed_model.h).
enum class Stems { One, Several, Composed };

// Returns the rules of a model after its axiom: for apex, stem and organs. They use the macros LEN,
// STEM, DX, ROLL and LAYERS, and DIVERGENCE and WHORL for patterns that have them, and the arrays
// `at` and `nodes`; rules for several stems also use the arrays foot, bears, taper, low, own and
// organs (several_stem_model.cpp). If sizes follow half-ellipses they use SIDES and the array
// azimuth, or for several stems the arrays azimuth, sides and first.
//
// If layers have different organs, as in a composed model, Q(z, h) is an organ of relative size h
// in the layer whose table entry is z, and for several stems Q(s, z, h). The placeholder <leaves>
// is to be replaced by homomorphism rules for organs that are not leaves; those for leaves, 0 in
// the array organ, are included. ROLL and the pattern are replaced by the arrays roll and pattern
// if the tables have them.
//
// In a composed model functions are numbered from <offset>, and <calls> is to be replaced by rules
// for organs that are models.
std::string stem_rules(Pattern const& pattern, Stems stems, Pattern::Sizes sizes,
                       LayerTables const* layers = nullptr);

} // namespace tractus::lines
