#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree.h"

#include <array>
#include <cstdint>

namespace tractus::silhouette {

// What a person sets of a tree beside its lines.
struct TreeForm {
    int levels = 2;                     // How often branches branch before twigs come: 1 to 3.
    std::array<Pattern, 3> patterns {}; // Around the trunk, its branches, and those of these.
    double density = 1;                 // Times as many branches that nobody drew: 0 to 10.
    // A style on the levels where it is set: density says nothing there (measured_style.h).
    std::array<BranchStyle, 3> styles {};
    int leaves = 24;         // On a twig: 1 to 500.
    double leaf_width = 0.4; // A share of a leaf's length: 0.01 to 2.
    std::uint64_t seed = 1;  // Of what the drawing leaves open.
    // The branches of a node stand there together (ArrangementOptions::Nodes::Whole). Trees from
    // before there was this stay as they are.
    bool has_whole_nodes = false;

    bool operator==(TreeForm const&) const = default;
};

// Whether nobody has chosen anything of it: chance and how nodes are kept are no choice.
bool is_usual(TreeForm form);

// About how many branches the form's styles give on the last level; 1 for a form without styles.
double styled_branches(TreeForm const& form);
constexpr double kMostStyled = 200'000;

Result<void> check_form(TreeForm const& form); // Refuses what is out of range, as the user's fault.

SkeletonOptions skeleton_options(TreeForm const& form);
TreeOptions tree_options(TreeForm const& form, double height_mm);

} // namespace tractus::silhouette
