#pragma once

#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/pattern.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::lines {

// A sketch as measured whose organs may be sketches of their own (2008, section 5).
struct ComposedSketch {
    Construction construction;
    Pattern pattern {};
    std::vector<ComposedSketch> organs {};
    // Of each layer, from below, which of them its organs are, from 1; 0: leaves. Layers behind the
    // end of the list have what the last of it has; an empty list: leaves everywhere.
    std::vector<std::size_t> organ_of_layer {};
};

constexpr std::size_t kMostSketches = 12;            // In a composed one.
constexpr std::size_t kMostComposedLeaves = 100'000; // Of its plant.

// The plant as a model in cpfg's language, as write_model() has it of the sketch alone. Each sketch
// is an L-system that the one whose organs are its plants calls: an organ's stem is as long as a
// leaf would be in its place, so its top is on the boundary. Fails, as the user's fault, for more
// sketches or leaves than there may be, and for an organ that is not there.
Result<LineModel> write_composed_model(ComposedSketch const& sketch, std::string const& name);

} // namespace tractus::lines
