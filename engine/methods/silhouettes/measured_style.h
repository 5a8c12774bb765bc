#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/plant/plant.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tractus::silhouette {

// What a plant's axes of one order bear.
struct MeasuredLevel {
    std::size_t parents = 0; // Axes that bear any.
    std::size_t children = 0;
    BranchStyle style {};
    Pattern pattern = Pattern::Even;
    double node_size = 1; // Children that stand at one place of their parent, on average.
    // The turn from a child to the next, or from a node to the next, 0 to 180, and how sure it is:
    // 0 for any turn, 1 where all are the same.
    double divergence_deg = 0;
    double divergence_sureness = 0;
    double mean_angle_deg = 0; // Of all children.
    // Of children, as shares of their parents' lengths: in the lower, the middle and the upper
    // third of the branched part; 0 where there are none.
    std::array<double, 3> lengths {};
};

// How a plant branches, whatever made it.
struct MeasuredStyle {
    std::vector<MeasuredLevel> levels; // Of the trunk's branches, then theirs: 1 to 3.
    int orders = 0;                    // How often the plant branches, twigs that are axes too.
    double leaves_per_twig = 0;        // 0: it has no leaves.
    double leaf_width = 0;             // A share of a leaf's length.
    bool has_sprays = false;           // Its twigs are organs (spray.h), no axes.
};

// Measures a plant. A child that goes straight on from its parent's tip is the parent's
// continuation and counts as none. Fails, as the user's fault, for a plant without branches. The
// same plant gives the same numbers.
Result<MeasuredStyle> measure_style(Plant const& plant);

// A tree's form that has the style. Twigs that are axes become a form's twigs, so such plants lose
// their last level.
TreeForm form_of(MeasuredStyle const& style);

} // namespace tractus::silhouette
