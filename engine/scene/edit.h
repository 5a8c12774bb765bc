#pragma once

#include "engine/lsystem/model.h"
#include "engine/plant/plant.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/association.h"
#include "engine/variation/growth.h"
#include "engine/variation/motion_indicator.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tractus {

// What the user did, as values. A scene is the fold of its edits, so an edit holds all that is
// needed to do it again: the model's text, the pen's tips, the chosen segments.

// Takes a base plant; everything associated with another one goes with it.
struct LoadModel {
    ModelSource source;
    std::map<std::string, std::string> includes {}; // What the model includes, by name: the texts.
    std::optional<int> steps {};                    // Derivation steps; no value: the model's own.
    std::uint64_t seed = 1;                         // Of the model's stochastic rules.
};

// Paths of segments, each from root to tip.
using Selection = std::vector<std::vector<SegmentId>>;

// Chooses what the next associations go to, in place of what was chosen. Usually one path, or one
// for each branch that the pen left undetermined (Streit 2006, section 4.1); none chooses nothing.
struct Select {
    Selection paths;
};

// Lets a stroke shape each selected path, its descendants, or both (Streit 2006, section 4.3).
struct Associate {
    Stroke stroke;
    Propagation propagation = Propagation::Selected;
};

// Adds one motion indicator (Streit 2006, section 4.4).
struct Indicate {
    MotionIndicator indicator;
};

// Sets how plants grow from here on.
struct SetGrowth {
    GrowthParameters parameters;
    std::uint64_t seed = 1; // Of the variations.
};

using Edit = std::variant<LoadModel, Select, Associate, Indicate, SetGrowth>;

} // namespace tractus
