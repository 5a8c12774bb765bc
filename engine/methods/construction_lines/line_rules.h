#pragma once

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
// In a composed one functions are numbered behind <offset>, and where it says <calls> rules for
// Q(z, h), an organ of layer z with a size by LEN, are to stand in; the array organ says of each
// layer whether leaves stand there: 0.
std::string stem_rules(Pattern const& pattern, Stems stems, Pattern::Sizes sizes);

} // namespace tractus::lines
