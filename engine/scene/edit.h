#pragma once

#include "engine/lsystem/model.h"
#include "engine/plant/skeleton_lines.h"
#include "engine/stroke/erase_tips.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/association.h"
#include "engine/variation/growth.h"
#include "engine/variation/motion_indicator.h"
#include "engine/variation/select_branches.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tractus {

// What the user did, as values. A scene is the fold of its edits, so an edit holds all that is
// needed to do it again: the model's text, the pen's tips, the chosen segments.

// What becomes of what was drawn when the plant changes.
enum class Drawn {
    Forget, // Another plant: strokes and indicators go.
    Keep,   // The same plant, edited: what was drawn on branches goes to those at the same place
          // (branch_address.h). Where there is none it is orphaned: kept without effect, and found
          // again when a later edit brings the branch back.
};

// Takes a base plant from an L-system.
struct LoadModel {
    ModelSource source;
    std::map<std::string, std::string> includes {}; // What the model includes, by name: the texts.
    std::optional<int> steps {};                    // Derivation steps; no value: the model's own.
    std::uint64_t seed = 1;                         // Of the model's stochastic rules.
    Drawn drawn = Drawn::Forget;
};

// Takes a base plant from the lines that another program drew of it (skeleton_lines.h).
struct LoadSkeleton {
    std::string name {};
    std::vector<SkeletonPiece> lines {};
    Drawn drawn = Drawn::Forget;
};

// Chooses what the next associations go to, in place of what was chosen. Usually one path, or one
// for each branch that the pen left undetermined (Streit 2006, section 4.1); none chooses nothing.
struct Select {
    Selection paths;
};

// Lets a stroke shape each selected path, its descendants, or both (Streit 2006, section 4.3).
struct Associate {
    Stroke stroke;
    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;
    double detail_weight = 1; // See Association.
};

// The next ones edit strokes that shape something already: those with these numbers in
// Scene::associations, at least one.

// Redraws a part of them (oversketch.h).
struct Oversketch {
    std::vector<std::size_t> associations;
    Stroke over;
};

// From here on keeps so much of the hand in them, 0 (smooth) to 1 (as drawn).
struct SmoothStroke {
    std::vector<std::size_t> associations;
    double detail_weight = 0;
};

// Takes them away; what they overrode counts again.
struct DeleteStroke {
    std::vector<std::size_t> associations;
};

// Takes these tips of each of them away (erase_tips.h); where none would be left that shape
// anything, DeleteStroke takes the whole.
struct EraseTips {
    std::vector<std::size_t> associations;
    std::vector<TipRange> ranges; // Of its tips as they are now, in order.
};

// Adds one motion indicator (Streit 2006, section 4.4).
struct Indicate {
    MotionIndicator indicator;
};

// Puts another in the place of the indicator with this number in Scene::indicators.
struct ChangeIndicator {
    std::size_t number = 0;
    MotionIndicator indicator;
};

struct DeleteIndicator {
    std::size_t number = 0;
};

// Sets how plants grow from here on.
struct SetGrowth {
    GrowthParameters parameters;
    std::uint64_t seed = 1; // Of the variations.
    double variability = 1; // At which the parameters count; see at_variability().
    double age = 1;         // See Grower::grow().
};

using Edit
    = std::variant<LoadModel, Select, Associate, Indicate, SetGrowth, LoadSkeleton, Oversketch,
                   SmoothStroke, DeleteStroke, ChangeIndicator, DeleteIndicator, EraseTips>;

} // namespace tractus
