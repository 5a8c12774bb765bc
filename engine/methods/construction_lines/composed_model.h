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

// What may stand in the place of a plain leaf: a surface, or the plant of another sketch.
struct LineOrgan {
    OrganSurface surface {}; // Counts where there is no sketch.
    std::shared_ptr<ComposedSketch const> sketch {};
};

// A sketch as measured whose layers may bear different organs: leaves, surfaces, and plants of
// sketches of their own (2008, section 5).
struct ComposedSketch {
    std::vector<MeasuredStem> stems; // At least one. Their layers name organs by their numbers.
    Pattern pattern {};
    std::vector<LineOrgan> organs {};
    OrganSurface leaf {}; // What its leaves are; no patches: plain blades.
};

constexpr std::size_t kMostSketches = 12;            // In a composed one.
constexpr std::size_t kMostSurfaces = 11;            // That are organs of layers, in all of them.
constexpr std::size_t kMostComposedLeaves = 100'000; // Of its plant.

// The plant as a model in cpfg's language, as write_model() has it of the sketch alone, which it is
// where all layers bear leaves in the plant's pattern. Each sketch is an L-system that the one
// whose organs are its plants calls: an organ's stem is as long as a leaf would be in its place, so
// its top is on the boundary. Surfaces are files (.s) that the view names, as long as leaves.
//
// Fails, as the user's fault, for more sketches, surfaces or leaves than there may be, for an organ
// that is not there, and for a sketch of several stems that bears plants of sketches, or is one.
Result<LineModel> write_composed_model(ComposedSketch const& sketch, std::string const& name);

} // namespace tractus::lines
