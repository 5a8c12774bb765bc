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

// A stroke of a sketch before it is read.
struct StrokeToExplain {
    std::vector<Vec3> points; // As of LineRecogniser::add().
    // What a person has said that it is. No value: to be found out.
    std::optional<Role> said {};
    bool is_by_hand = false; // Also where its points are far apart: its tremor is taken out.
    bool is_clean = false;   // Hooks and tremor have been taken out already.
    bool turn_round = false; // Of the stem: it begins where it would be taken to end.
};

// What a stroke was read as.
struct ExplainedStroke {
    Role role = Role::Unsure;
    // The stroke with which it makes one line: of a piece the first that was drawn of the line, of
    // a line that is drawn again, wholly or in part, the one in whose place it stands.
    std::optional<std::size_t> of {};
    bool is_replaced = false;     // Another stroke stands in its place, wholly.
    bool is_turned_round = false; // The stem was drawn from its top to its foot.
    std::string reason {};        // Unsure: a sentence that says why, and what to draw instead.
};

// A reading of all strokes of a sketch of one stem.
struct Explanation {
    std::vector<ExplainedStroke> strokes; // One for each.
    LineSketch sketch {};                 // Of all that count; without numbers of nodes.
    // For each of the sketch's inclination lines the number of its stroke, or of the first of its
    // halves or pieces.
    std::vector<std::size_t> inclination_strokes {};
    double cost = 0; // Less is better; 0 where every stroke is drawn as it is meant.
};

// Explains all strokes of a sketch together, whatever their order and direction. Any stroke, and
// any strokes that go on in each other, may be the stem; given one, each other stroke may be a
// boundary or both of them, an inclination line or half of one, a piece of such a line, a part of
// one that is drawn again, or nothing. Each of these has a price by how the stroke lies to the stem
// and to the others; the readings come the cheapest first. At most two: the second one differs from
// the first in what some stroke is.
//
// Hooks and tremor of lines that are drawn by hand are taken out (hand_line.h). A stem stands
// upwards, and so that what inclination lines show leans to its top, whichever way it was drawn.
//
// At least one stroke, each of at least two points.
std::vector<Explanation> explain_sketch(std::span<StrokeToExplain const> strokes);

} // namespace tractus::lines
