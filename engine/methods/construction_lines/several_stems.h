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

// One of the stems of a plant, with its lines. The lines of all stems are on the same sheet.
struct StemLines {
    LineSketch sketch {};
    // Number of the parent stem, which must come earlier. A stem with a parent is a lateral axis
    // or, if it is attached to its parent's top, a branch of a fork. No value: a stem that stands
    // separately.
    std::optional<std::size_t> parent {};
};

// A measured stem, and the place where it is attached to its parent.
struct MeasuredStem {
    Construction construction;
    std::optional<std::size_t> parent {};
    // Position of the stem's foot on its parent, as a share of the parent's length; 1: at the top.
    double foot_x = 0;
    // Number of the stem whose lines define this stem's organs: this stem if it has a boundary.
    std::size_t functions = 0;
};

// Returns the number of the stem to which a new stem is attached that begins at this point of the
// sheet: the nearest stem whose line passes within 5 mm. No value if there is none. A new stem that
// begins near the foot of that stem stands beside it, as in a clump: it gets the same parent, if
// any.
std::optional<std::size_t> parent_at(std::span<StemLines const> stems, Vec2 const& foot_mm);

// Returns, for each stem, the number of the stem whose lines define its organs. This is the stem
// itself if it has a boundary, or if no stem has one. Otherwise it is the source of its parent or,
// for a stem without a parent, the first stem with a boundary.
std::vector<std::size_t> function_sources(std::span<StemLines const> stems);

// Measures the stems of a plant, at least one. A single stem is measured as by measure_sketch(). A
// stem without a boundary has the nodes and organs of its function source (function_sources()),
// scaled to its own length. The foot of an attached stem is moved onto its parent, while its top
// keeps its place on the sheet.
//
// Fails like measure_sketch(); with several stems the message names the stem.
Result<std::vector<MeasuredStem>> measure_stems(std::vector<StemLines> stems,
                                                Missing missing = Missing::Refused);

// Returns the assumptions made in measuring all stems, one sentence each.
std::vector<std::string> notes_of(std::span<MeasuredStem const> stems);

// True if any of the stems has a boundary, so that the plant may have organs.
bool has_boundary(std::span<StemLines const> stems);

} // namespace tractus::lines
