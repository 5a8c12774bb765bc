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
    // Number of branches, not counting the trunk's own end, that a crown gets if its outline has
    // fewer bumps (spaced_ends.h). 0: a crown gets one branch per bump, then others until enough of
    // it is covered.
    std::size_t branches = 0;
    double unbranched = 0; // Share of the trunk, from its base, on which no branch is inferred.
    // Drawn branches may start only on the part of the trunk inside the outline, or anywhere on it.
    enum class DrawnBases { InOutline, Anywhere } drawn_bases = DrawnBases::InOutline;
};

// A trunk, the silhouette around it, and the branches inferred from them, in millimetres of the
// drawing plane.
struct BranchingSystem {
    std::vector<Vec2> outline; // Outline of the crown: equally spaced points, counter-clockwise.
    std::vector<Vec2> trunk;   // Trunk as 64 samples, base first.
    // End of the trunk's straight extension: the apex bump's end or the base of the farthest branch
    // beyond the trunk; no value if the trunk has no extension.
    std::optional<Vec2> trunk_goes_on_to;
    Run inside; // Range of the trunk samples inside the outline, where branches may start.
    ChordalAxis::Counts triangles;
    std::vector<Bump> bumps;
    // First one branch per lateral bump, in the order of the bumps (a drawn branch where one ends
    // in the bump), then the other drawn branches, then the added ones.
    std::vector<Branch> branches;
    // Share of the outline's area covered by crowns before branches are added to fill the rest.
    double coverage_before = 0;
    double coverage_after = 0; // Share of the outline's area covered by the crowns of all branches.
    std::vector<std::string> notes;
    // True if the outline was drawn for the system's branch, or if the system follows the style of
    // a system whose outline was drawn.
    bool is_of_own_outline = false;
    // Number of touches that matched one of the system's bumps (bump_touch.h).
    std::size_t touches_taken = 0;
    // The leaf, if the whole crown is one; there are no branches then.
    std::optional<LeafBlade> leaf {};
    // True if the system follows a sibling's style, or if its siblings follow its style
    // (sibling_style.h). The system then takes no other style.
    bool is_in_siblings_style = false;

    // The trunk with its extension, equally spaced or nearly so. If an apex branch continues the
    // trunk, the extension is left out.
    std::vector<Vec2> whole_trunk() const;
    bool has_apex_branch() const
    {
        return !branches.empty() && branches.back().origin == Branch::Origin::Apex;
    }
};

// Share of the outline's area that is covered by the branches' crowns.
double coverage_of(BranchingSystem const& system);

// Infers the branches of a drawing. Fails like clean_drawing(), and with a user error if the trunk
// is wholly outside the outline.
Result<BranchingSystem> infer_system(Drawing const& drawing, InferenceOptions const& options = {});

} // namespace tractus::silhouette
