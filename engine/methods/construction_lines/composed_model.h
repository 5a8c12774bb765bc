#pragma once

#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/organ_surface.h"
#include "engine/methods/construction_lines/pattern.h"
#include "engine/methods/construction_lines/several_stems.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace tractus::lines {

struct ComposedSketch;

// What a composed model has in place of plain leaves: a surface, or the plant of another sketch.
struct LineOrgan {
    OrganSurface surface {}; // Surface of the organ; used if `sketch` is null.
    std::shared_ptr<ComposedSketch const> sketch {};
};

// A measured sketch whose layers may have different organs: leaves, surfaces, and plants of other
// sketches (Anastacio et al. 2008, section 5).
struct ComposedSketch {
    // Stems of the sketch, at least one. The layers of a stem refer to `organs` by number, from 1.
    std::vector<MeasuredStem> stems;
    Pattern pattern {};
    std::vector<LineOrgan> organs {};
    // Surface of the plant's leaves; a surface without patches stands for plain blades.
    OrganSurface leaf {};
};

constexpr std::size_t kMaxSketches = 12; // Maximum number of sketches in a composed model.
// Maximum number of surfaces used as organs, in all sketches together.
constexpr std::size_t kMaxSurfaces = 11;
constexpr std::size_t kMaxComposedLeaves = 100'000; // Maximum number of leaves of the whole plant.

// Writes the plant as a model in cpfg's language. If all layers have leaves in the plant's pattern,
// the result is that of write_model() for the sketch alone. Each sketch becomes an L-system. If its
// plant is an organ of another sketch, the L-system of the latter calls it, with a stem as long as
// a leaf would be in the organ's place, so that the top of the stem lies on the boundary. Each
// surface is a file (.s) that the view names, and is scaled to the length of a leaf.
//
// Fails with a user error if there are too many sketches, surfaces or leaves, if an organ does not
// exist, or if a sketch with several stems is used as an organ or has organs that are sketches.
Result<LineModel> write_composed_model(ComposedSketch const& sketch, std::string const& name);

} // namespace tractus::lines
