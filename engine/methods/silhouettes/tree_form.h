#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree.h"
#include "engine/plant/bark.h"

#include <array>
#include <cstdint>

namespace tractus::silhouette {

// The settings of a tree apart from its lines.
struct TreeForm {
    int levels = 2; // Branching levels below the twigs, 1 to 3.
    // Branching patterns around the trunk, around its branches, and around their branches.
    std::array<Pattern, 3> patterns {};
    double density = 1; // Factor on the number of added branches, 0 to 10.
    // Styles by level; on a level with a style, `density` has no effect (measured_style.h).
    std::array<BranchStyle, 3> styles {};
    int leaves = 24;         // Number of leaves per twig, 1 to 500.
    double leaf_width = 0.4; // Width of a leaf as a share of its length, 0.01 to 2.
    std::uint64_t seed = 1;  // Seed for everything that the drawing leaves open.
    // True: all branches of a node share one position (ArrangementOptions::Nodes::Whole). False for
    // trees from before this option existed.
    bool has_whole_nodes = false;
    // Number of branches in the plane of the drawing, not counting the trunk's end, if the outline
    // has fewer bumps (InferenceOptions::branches); up to kMaxPlaneBranches. 0 for trees from
    // before this option existed: they have one branch per bump, then others until the crown is
    // covered.
    int plane_branches = 0;
    // True: the leaves fill the outline as seen (TreeOptions::leaves_reach_outline). False for
    // trees from before this option existed.
    bool leaves_reach_outline = false;
    // Branching angles at the trunk's base and tip, degrees; 0: the default (BranchingAngles).
    double base_angle_deg = 0;
    double tip_angle_deg = 0;
    // True: the trunk's branches begin where they leave it at these angles
    // (BranchingAngles::Bases). False for trees from before this option existed.
    bool bases_by_angle = false;
    // How the trunk's branches rise towards their ends (BranchingAngles::rise()), -2 to 2; 0: the
    // default.
    double rise = 0;
    // Bark of the trunk and branches; Furrowed for trees from before this option existed.
    BarkKind bark = BarkKind::Furrowed;

    bool operator==(TreeForm const&) const = default;
};

constexpr int kUsualPlaneBranches = 26;
constexpr int kMaxPlaneBranches = 60;

// True if nothing was set by hand; the seed, has_whole_nodes, leaves_reach_outline and
// bases_by_angle do not count.
bool is_usual(TreeForm form);

// Approximate number of branches on the last level according to the form's styles; 1 for a form
// without styles.
double styled_branches(TreeForm const& form);
constexpr double kMaxStyled = 200'000;

// Checks a form. Fails with a user error if a value is out of range.
Result<void> check_form(TreeForm const& form);

SkeletonOptions skeleton_options(TreeForm const& form);
TreeOptions tree_options(TreeForm const& form, double height_mm);

} // namespace tractus::silhouette
