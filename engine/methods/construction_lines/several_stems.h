#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::lines {

// One of the stems of a plant, with the lines that belong to it, all on the same sheet.
struct StemLines {
    LineSketch sketch {};
    // The number of the stem on which it stands, which comes before it: a lateral axis, or above
    // the other one's top a fork of it. No value: it stands beside the first one.
    std::optional<std::size_t> parent {};
};

// A stem as measured, standing where it is borne.
struct MeasuredStem {
    Construction construction;
    std::optional<std::size_t> parent {};
    double foot_x = 0; // Where on the parent it stands; 1: on its top.
    // Whose lines say what grows on it: its own number if it has a boundary.
    std::size_t functions = 0;
};

// The earlier stem that bears one which begins at this place of the sheet: the nearest whose line
// passes within 5 mm of it. No value if there is none, and at an earlier one's foot, where stems of
// a clump begin.
std::optional<std::size_t> parent_at(std::span<StemLines const> stems, Vec2 const& foot_mm);

// Whose lines say what grows on each stem: its own if it has a boundary; else its parent's, or if
// it has none those of the first stem with a boundary; its own if no stem has one.
std::vector<std::size_t> function_sources(std::span<StemLines const> stems);

// Measures the stems of a plant, at least one; a single one as measure_sketch() does. A stem
// without a boundary of its own has the nodes and organs of the stem that function_sources() names,
// by its own length. One that stands on another is moved to it at its foot, and not at its top.
//
// Fails like measure_sketch(), and says of which stem.
Result<std::vector<MeasuredStem>> measure_stems(std::vector<StemLines> stems,
                                                Missing missing = Missing::Refused);

// What had to be guessed, of all of them, a sentence each.
std::vector<std::string> notes_of(std::span<MeasuredStem const> stems);

// Whether any of them has a boundary, so that organs may stand on the plant.
bool has_boundary(std::span<StemLines const> stems);

} // namespace tractus::lines
