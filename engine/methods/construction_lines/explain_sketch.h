#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/recognise_line.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::lines {

// A stroke of a sketch to be interpreted.
struct StrokeToExplain {
    std::vector<Vec3> points; // Points in the format of LineRecogniser::add().
    // The role that the user has assigned. Without a value the role is to be found.
    std::optional<Role> assigned {};
    // True for a stroke drawn by hand even if its points are far apart: its tremor is removed.
    bool is_by_hand = false;
    bool is_clean = false;   // True if hooks and tremor have already been removed.
    bool turn_round = false; // True for a stem that begins where it would be assumed to end.
};

// Interpretation of a stroke.
struct ExplainedStroke {
    Role role = Role::Unsure;
    // The stroke that forms one line with this one: for a piece, the first drawn stroke of the
    // line; for a line redrawn wholly or in part, the stroke that it replaces.
    std::optional<std::size_t> of {};
    bool is_replaced = false;       // True if another stroke has replaced this one completely.
    bool is_drawn_reversed = false; // True if the stem was drawn from its top to its foot.
    // Reason why a stroke is Unsure: one sentence, with what to draw instead.
    std::string reason {};
};

// An interpretation of all strokes of a sketch with one stem.
struct Explanation {
    std::vector<ExplainedStroke> strokes; // Interpretation of each stroke.
    // The sketch given by all strokes that have an effect; without numbers of nodes.
    LineSketch sketch {};
    // Index of the stroke of each inclination line of the sketch, or of the first of its halves or
    // pieces.
    std::vector<std::size_t> inclination_strokes {};
    // Cost of the interpretation: lower is better; 0 if every stroke is drawn exactly as intended
    // for its role.
    double cost = 0;
};

// Interprets all strokes of a sketch together, whatever their order and direction. Any stroke, or
// strokes that continue each other, may be the stem. Given a stem, each other stroke may be a
// boundary or both boundaries, an inclination line or half of one, a piece of such a line, a
// correction of a part, or nothing. Each alternative has a cost that depends on the stroke's
// position relative to the stem and the others. Returns one or two interpretations, the cheapest
// first; the second differs from the first in the role of some stroke.
//
// Hooks and tremor of hand-drawn lines are removed (hand_line.h). The stem is oriented upwards, and
// such that the organs shown by inclination lines lean towards its top, whichever way it was drawn.
//
// `strokes`: at least one, each with at least two points.
std::vector<Explanation> explain_sketch(std::span<StrokeToExplain const> strokes);

} // namespace tractus::lines
