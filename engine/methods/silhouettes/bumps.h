#pragma once

#include "engine/methods/silhouettes/chordal_axis.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// What a bump of an outline is to the tree.
enum class Role {
    Foot,    // The trunk comes in through it: it bears nothing.
    Apex,    // The trunk ends in it.
    Lateral, // A branch ends in it.
};

// A part that sticks out of a silhouette: a limb of its chordal axis that rises enough.
struct Bump {
    Arc arc;                 // The part of the outline that is the bump's own.
    Arc cap;                 // The part around its end, beyond `end`.
    Vec2 end = Vec2::Zero(); // The central point E: about a lobe's middle, nearly a spike's tip.
    Vec2 tangent = Vec2::Zero(); // How a branch arrives at E: towards the cap. Length 1.
    double radius = 0;           // Of the cap, as a circle.
    Vec2 tip = Vec2::Zero();     // The cap's farthest point along `tangent`.
    double strength = 0;         // How far it rises over the least that counts; 0: no junction.
    Role role = Role::Lateral;
    std::optional<std::size_t> touch {}; // Which touch made it (bump_touch.h); no value: none.
};

// How much a limb has to rise over the circle around its junction to count.
struct BumpThresholds {
    double rise_of_diagonal = 0.012; // As a share of the diagonal of the outline's box,
    double rise_of_chord = 0.06;     // and of the chord where it begins.
};

// The bumps of an outline in the order of their arcs. Limbs that rise too little are taken off, the
// weakest first, each of which may make its junction a sleeve. Where no junction is left, as in an
// ellipse, there are two: beyond the longest chord, each way. Roles are not set.
std::vector<Bump> find_bumps(ChordalAxis const& axis, BumpThresholds const& thresholds = {});

// Whether the half circle over the ends of an arc holds all of it.
bool holds_cap(std::span<Vec2 const> outline, Arc const& arc);

// A bump by its arc and its cap.
Bump describe_bump(std::span<Vec2 const> outline, Arc const& arc, Arc const& cap, double strength);

// Samples from one to another, both among them.
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
};

// The longest run of the samples of a trunk that is inside of the outline; no value if none is.
std::optional<Run> inside_run(std::span<Vec2 const> outline, std::span<Vec2 const> trunk);

// Sets roles. `run`: the trunk's samples inside. The two ends of an outline that is about round are
// its foot and its apex. Answers where the trunk would go on to where it
// has neither an apex nor a fork ahead: 85 % of the way straight on to the outline.
std::optional<Vec2> set_roles(std::vector<Bump>& bumps, std::span<Vec2 const> outline,
                              std::span<Vec2 const> trunk, Run const& run);

} // namespace tractus::silhouette
