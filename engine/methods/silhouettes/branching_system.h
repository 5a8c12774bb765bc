#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/fill.h"
#include "engine/methods/silhouettes/outline.h"

#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

struct InferenceOptions {
    OutlineOptions outline {};
    BumpThresholds bumps {};
    FillOptions fill {};
    BranchingAngles angles {};
    double unbranched = 0; // A share of the trunk: below it none is inferred.
    // Where branches that are drawn stand.
    enum class DrawnBases { InOutline, Anywhere } drawn_bases = DrawnBases::InOutline;
};

// A trunk, a silhouette around it, and the branches that follow from them, millimetres in the plane
// of the drawing.
struct BranchingSystem {
    std::vector<Vec2> outline; // In equal steps, counter-clockwise.
    std::vector<Vec2> trunk;   // 64 samples, base first,
    // and where it is extended to: its apex, or as far as branches stand ahead of it.
    std::optional<Vec2> trunk_goes_on_to;
    Run inside; // The samples that may bear branches.
    ChordalAxis::Counts triangles;
    std::vector<Bump> bumps;
    // One for each lateral bump, in their order, which is the drawn one where one ends there; then
    // the others that were drawn, and those added.
    std::vector<Branch> branches;
    double coverage_before = 0; // Shares of the outline's inside that crowns cover, with the
    double coverage_after = 0;  // branches of bumps alone, and with all.
    std::vector<std::string> notes;
    // Its outline is one that was drawn for a branch, or it follows such a system's style.
    bool is_of_own_outline = false;
    std::size_t touches_taken = 0; // Of those on its bumps, which found theirs (bump_touch.h).
    // All of it is one leaf, and there are no branches; no value: it is none.
    std::optional<LeafBlade> leaf {};
    // It has a sibling's style, or siblings have its: no other style is for it (sibling_style.h).
    bool is_in_siblings_style = false;

    // The trunk with what it is extended by, in equal steps or nearly so. Without what a branch of
    // its own continues it by: its apex.
    std::vector<Vec2> whole_trunk() const;
    bool has_apex_branch() const
    {
        return !branches.empty() && branches.back().origin == Branch::Origin::Apex;
    }
};

// The share of the outline's inside that the branches' crowns cover.
double coverage_of(BranchingSystem const& system);

// Infers the branches of a drawing. Fails like clean_drawing(), and, as the user's fault, where the
// trunk is wholly outside of the outline.
Result<BranchingSystem> infer_system(Drawing const& drawing, InferenceOptions const& options = {});

} // namespace tractus::silhouette
