#pragma once

#include "engine/methods/silhouettes/chordal_axis.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// The function of a bump in the tree.
enum class Role {
    Foot,    // The bump through which the trunk enters; no branch ends in it.
    Apex,    // The bump in which the trunk ends.
    Lateral, // A bump in which a lateral branch ends.
};

// A protruding part of a silhouette: a limb of its chordal axis that protrudes by more than a
// threshold.
struct Bump {
    Arc arc; // The part of the outline that belongs to the bump.
    Arc cap; // The part of the arc around the bump's tip, beyond `end`.
    // Central point E of a bump (Wither 2009): near the middle of a lobe, near the tip of a spike.
    Vec2 end = Vec2::Zero();
    // Unit vector of the direction in which a branch reaches `end`, towards the cap.
    Vec2 tangent = Vec2::Zero();
    double radius = 0;       // Radius of the cap, taken as a circle.
    Vec2 tip = Vec2::Zero(); // The cap's farthest point along `tangent`.
    // Rise of the bump divided by the minimum rise of a bump; 0: the outline has no junction
    // triangle.
    double strength = 0;
    Role role = Role::Lateral;
    // Index of the touch that made the bump (bump_touch.h); no value if none did.
    std::optional<std::size_t> touch {};
};

// Thresholds for a limb to count as a bump: how far it must rise out of the circumcircle of its
// junction triangle.
struct BumpThresholds {
    // Minimum rise as a share of the diagonal of the outline's bounding box.
    double rise_of_diagonal = 0.012;
    double rise_of_chord = 0.06; // Minimum rise as a share of the chord at the limb's base.
    // The chords that are tried for a bump's end. The end is the middle of the first chord, from
    // the bump's base outwards, whose half disc contains the outline beyond the chord.
    enum class Ends {
        // Edges of triangles. In a round lobe, whose points lie on one circle, tremor decides which
        // triangles there are, and ends move by more than a tenth of the diagonal.
        OfTriangles,
        // Chords that narrow evenly from both ends of the bump's arc.
        Even,
    } ends
        = Ends::OfTriangles;
};

// The bumps of an outline, in the order of their arcs. Limbs that rise too little are removed,
// weakest first; this may turn their junction triangle into a sleeve triangle. If no junction is
// left, as in an ellipse, the result is two bumps: the parts of the outline on either side of the
// longest chord. Roles are not assigned yet.
std::vector<Bump> find_bumps(ChordalAxis const& axis, BumpThresholds const& thresholds = {});

// True if the half disc over the ends of an arc contains the whole arc, up to a tolerance given as
// a share of the disc's radius.
bool contains_cap(std::span<Vec2 const> outline, Arc const& arc, double tolerance = 1e-9);

// Computes the bump that has the given arc and cap.
Bump describe_bump(std::span<Vec2 const> outline, Arc const& arc, Arc const& cap, double strength);

// A range of samples, both ends included.
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
};

// The longest run of trunk samples inside the outline; no value if none is inside.
std::optional<Run> inside_run(std::span<Vec2 const> outline, std::span<Vec2 const> trunk);

// Assigns roles to an outline's bumps. `run` is the range of trunk samples inside the outline. In
// an outline that is nearly round, the two end bumps become foot and apex. If the trunk has neither
// an apex nor a fork ahead, returns the point to which the trunk should be extended: straight on,
// 85 % of the way to the outline. The foot is the bump through which the trunk enters, if the trunk
// passes the bump's end at less than `foot_reach` times the bump's radius.
std::optional<Vec2> set_roles(std::vector<Bump>& bumps, std::span<Vec2 const> outline,
                              std::span<Vec2 const> trunk, Run const& run, double foot_reach = 1);

} // namespace tractus::silhouette
