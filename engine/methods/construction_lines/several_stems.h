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

// One of the stems of a plant with its lines, all on the same sheet.
struct StemLines {
    LineSketch sketch {};
    // Number of the parent stem, which comes earlier: this stem is a lateral axis of it, or a fork
    // if it is attached at its top. No value: a separate stem beside the first one.
    std::optional<std::size_t> parent {};
};

// A measured stem and its place of attachment.
struct MeasuredStem {
    Construction construction;
    std::optional<std::size_t> parent {};
    // Position of the stem's foot on its parent, as a share of the parent's length; 1: on its top.
    double foot_x = 0;
    // Number of the stem whose lines define the organs: this stem if it has a boundary.
    std::size_t functions = 0;
};

// Returns the earlier stem to which one that begins at this point of the sheet is attached: the
// nearest whose line passes within 5 mm. No value if there is none, or if the point is near an
// earlier stem's foot, where stems of a clump begin.
std::optional<std::size_t> parent_at(std::span<StemLines const> stems, Vec2 const& foot_mm);

// Returns, for each stem, the one whose lines define its organs: itself if it has a boundary or no
// stem has one; otherwise the source of its parent; without a parent, the first stem with a
// boundary.
std::vector<std::size_t> function_sources(std::span<StemLines const> stems);

// Measures the stems of a plant, at least one; for a single stem like measure_sketch(). A stem
// without a boundary has the nodes and organs of its function source (function_sources()), scaled
// to its own length. The foot of an attached stem is moved onto its parent, while its top keeps its
// place on the sheet.
//
// Fails like measure_sketch(), with the name of the stem.
Result<std::vector<MeasuredStem>> measure_stems(std::vector<StemLines> stems,
                                                Missing missing = Missing::Refused);

// Returns the assumptions made in measuring all stems, one sentence each.
std::vector<std::string> notes_of(std::span<MeasuredStem const> stems);

// True if any of the stems has a boundary, so that the plant may have organs.
bool has_boundary(std::span<StemLines const> stems);

} // namespace tractus::lines
