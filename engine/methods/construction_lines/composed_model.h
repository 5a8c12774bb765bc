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

// A replacement for plain leaves: a surface, or the plant of another sketch.
struct LineOrgan {
    OrganSurface surface {}; // Surface of the organ; used if there is no sketch.
    std::shared_ptr<ComposedSketch const> sketch {};
};

// A measured sketch whose layers may have different organs: leaves, surfaces, and plants of other
// sketches (Anastacio et al. 2008, section 5).
struct ComposedSketch {
    // Stems of the sketch, at least one. Their layers refer to organs by number.
    std::vector<MeasuredStem> stems;
    Pattern pattern {};
    std::vector<LineOrgan> organs {};
    OrganSurface leaf {}; // Surface of the plant's leaves; without patches: plain blades.
};

constexpr std::size_t kMaxSketches = 12; // Maximum number of sketches in a composed sketch.
// Maximum number of surfaces used as organs, in all sketches together.
constexpr std::size_t kMaxSurfaces = 11;
constexpr std::size_t kMaxComposedLeaves = 100'000; // Maximum number of leaves of the plant.

// Writes the plant as a model in cpfg's language. If all layers have leaves in the plant's pattern,
// the result is that of write_model() for the sketch alone. Each sketch is an L-system that is
// called by the one whose organs are its plants: an organ's stem is as long as a leaf would be in
// its place, so its top is on the boundary. Surfaces are files (.s) named in the view, with the
// length of leaves.
//
// Fails with a user error if there are too many sketches, surfaces or leaves, an organ does not
// exist, or a sketch with several stems has plants of sketches as organs or is such an organ.
Result<LineModel> write_composed_model(ComposedSketch const& sketch, std::string const& name);

} // namespace tractus::lines
