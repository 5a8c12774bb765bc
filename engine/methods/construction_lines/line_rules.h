#pragma once

#include "engine/methods/construction_lines/layer_organs.h"
#include "engine/methods/construction_lines/pattern.h"

#include <string>

namespace tractus::lines {

// Whether a model has one stem, or several, whose numbers are then parameters of its modules; or
// one whose organs may be models of their own (composed_model.h).
enum class Stems { One, Several, Composed };

// A model's rules behind its axiom: the apex, the stem and the organs. They read LEN, STEM, DX,
// ROLL and LAYERS, DIVERGENCE and WHORL of patterns that have them, and the arrays at and nodes;
// those of several stems the arrays foot, bears, taper, low, own and organs, too
// (several_stem_model.cpp). Where sizes follow half-ellipses they read SIDES and the array azimuth,
// or those of several stems the arrays azimuth, sides and first.
//
// Where layers bear different organs, as in a composed model, Q(z, h) is an organ with a size by
// LEN in the layer whose entry of the tables is z, and of several stems Q(s, z, h). Where <leaves>
// stands rules of the homomorphism for those that are no leaves are to stand in; of leaves, 0 in
// the array organ, they are there. In place of ROLL and of the pattern they read the arrays roll
// and pattern if the tables have them.
//
// In a composed one functions are numbered behind <offset>, and where it says <calls> rules for
// organs that are models are to stand in.
std::string stem_rules(Pattern const& pattern, Stems stems, Pattern::Sizes sizes,
                       LayerTables const* layers = nullptr);

} // namespace tractus::lines
