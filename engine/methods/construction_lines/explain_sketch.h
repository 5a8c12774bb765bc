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
    std::vector<Vec3> points; // Points that meet the requirements of LineRecogniser::add().
    // The role that the user has assigned. No value: explain_sketch() finds the role.
    std::optional<Role> assigned {};
    // True if the stroke was drawn by hand. Its tremor is removed even if its points are far apart.
    bool is_by_hand = false;
    bool is_clean = false; // True if hooks and tremor have already been removed.
    // True: the stem runs opposite to the direction that explain_sketch() would find.
    bool turn_round = false;
};

// Interpretation of a stroke.
struct ExplainedStroke {
    Role role = Role::Unsure;
    // Index of another stroke that belongs to the same line: for a piece, the line's first drawn
    // stroke; for a stroke that redraws a line wholly or in part, the stroke that it replaces.
    std::optional<std::size_t> of {};
    bool is_replaced = false;       // True if another stroke has replaced this one completely.
    bool is_drawn_reversed = false; // True if the stem was drawn from its top to its foot.
    // Reason why a stroke is Unsure: one sentence, with what to draw instead.
    std::string reason {};
};

// An interpretation of all strokes of a sketch that has one stem.
struct Explanation {
    // Interpretation of each stroke, in the order of the strokes.
    std::vector<ExplainedStroke> strokes;
    // The sketch that results from all strokes that have an effect; it has no numbers of nodes yet.
    LineSketch sketch {};
    // For each inclination line of the sketch, the index of its stroke; for a line of several
    // halves or pieces, the index of the first of them.
    std::vector<std::size_t> inclination_strokes {};
    // Cost of the interpretation: lower is better; 0 if every stroke is drawn exactly as intended
    // for its role.
    double cost = 0;
};

// Interprets all strokes of a sketch together, whatever their order and direction. Any stroke, or
// several strokes that continue each other, may be the stem. Given a stem, each other stroke may be
// a boundary or an outline of both boundaries, an inclination line or half of one, a piece of such
// a line, a correction of part of a line, or nothing. Each alternative has a cost that depends on
// the stroke's position relative to the stem and to the other strokes. Returns one or two
// interpretations, the cheapest first; the second differs from the first in the role of at least
// one stroke.
//
// Hooks and tremor of hand-drawn lines are removed (hand_line.h). The stem is oriented upwards, and
// such that the organs shown by inclination lines lean towards its top, whichever way it was drawn.
//
// `strokes`: at least one, each with at least two points.
std::vector<Explanation> explain_sketch(std::span<StrokeToExplain const> strokes);

} // namespace tractus::lines
