#pragma once

#include "engine/base/random.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::silhouette {

constexpr int kUsualWhorl = 3; // Default number of branches in a whorl.
constexpr int kMinWhorl = 2;
constexpr int kMaxWhorl = 12;

// Phyllotactic pattern of the branches around their parent axis.
struct Pattern {
    enum Kind {
        Even,      // No nodes: branches are as far apart as possible.
        Spiral,    // One branch per node, divergence angle 144 degrees.
        Decussate, // Opposite pairs, each at right angles to the pair below.
        Whorls,    // `whorl` branches per node, placed in the gaps of the node below.
        TwoRows,   // Distichous: one branch per node, alternately left and right.
        Horizontal // Opposite pairs, all in the plane of the drawing.
    } kind
        = Even;
    // Number of branches per node of Whorls, kMinWhorl to kMaxWhorl; other kinds ignore it.
    int whorl = kUsualWhorl;

    constexpr Pattern() = default;
    constexpr Pattern(Kind of) // NOLINT(google-explicit-constructor): a kind alone is a pattern
                               // with the default whorl.
        : kind(of)
    {
    }
    static constexpr Pattern whorls_of(int branches)
    {
        Pattern pattern(Whorls);
        pattern.whorl = branches;
        return pattern;
    }

    bool operator==(Pattern const&) const = default;
    // Compares only the kind and ignores `whorl`.
    bool operator==(Kind of) const { return kind == of; }
};

// Reads "even", "spiral", "decussate", "whorls", "two-rows" or "horizontal"; no value for any other
// word.
std::optional<Pattern> pattern_of(std::string_view word);
char const* name_of(Pattern pattern);

// The pattern's name for users, for example "whorls of 5"; the default of three is just "whorls".
std::string describe(Pattern pattern);

// A position on the unrolled surface of the parent. u runs from 0 at its base to 1 at its tip.
// theta is the azimuth in degrees, 0 to below 360: 0 is to the right and 180 to the left in the
// plane of the drawing.
struct Place {
    double u = 0;
    double theta_deg = 0;
};

// A branch that is visible in the drawing. It normally keeps its u, and its theta stays within
// `most_off_deg` of the side where the branch was drawn.
struct DrawnPlace {
    double u = 0;
    double theta_deg = 0; // Side where the branch was drawn: 0 (right) or 180 (left).
    double most_off_deg = 45;
    // True: the branch keeps its u. False: with Nodes::Whole it may move to a node.
    bool keeps_u = true;
};

struct ArrangementOptions {
    Pattern pattern = Pattern::Even;
    std::size_t count = 0; // Number of branches in all, at least as many as were drawn.
    // Added branches are placed between this u and the tip.
    double first_u = 0;
    // Falloff of the proximity term (Wither 2009: 20). Default: twice the number of branches.
    std::optional<double> alpha {};
    int proposals = 3000;
    // How branches are placed in patterns with nodes.
    enum class Nodes {
        Whole, // The branches of a node share one u (whole_whorls.h).
        Snap, // Added branches move to the nearest node after the search, so nodes can hold more or
              // fewer branches than the pattern has.
        Free  // Branches need not be at nodes.
    } nodes
        = Nodes::Whole;
};

// Result of arrange().
struct Arrangement {
    std::vector<Place> places; // Positions of all branches: first the drawn ones, in their order.
    double cost_before = 0;
    // Final cost, never above cost_before. Both costs are taken before snapping.
    double cost_after = 0;
    int accepted = 0; // Number of proposed moves that were accepted.
};

// Distributes branches around their parent by depletion and replacement (Wither 2009, after
// Ripley): a randomly chosen branch is offered a random position within its limits and moves there
// if the cost summed over all pairs falls. Close pairs cost, and so do pairs that do not fit the
// pattern. `key` selects the random number stream.
Arrangement arrange(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                    RandomKey const& key);

// Pattern cost of two branches, with nodes `node` apart in u: 0 if they fit the pattern perfectly,
// at most 1/2.
double misfit(Pattern pattern, double node, Place const& a, Place const& b);

// Proximity cost of two branches: 1 at the same position, falling with their distance, and faster
// for a greater `alpha`.
double closeness(double alpha, Place const& a, Place const& b);

// Weights of closeness() and misfit() in the cost of two branches (w1 and w2 in Wither 2009).
constexpr double kClosenessWeight = 2;
constexpr double kMisfitWeight = 1;

// Branches per node of a pattern; 1 for a pattern without nodes.
std::size_t node_size(Pattern pattern);

// Rotation from one node to the next, degrees; 0 for a pattern without nodes.
double node_turn_deg(Pattern pattern);

// Distance in u between consecutive nodes of a parent with `count` branches in this pattern.
double node_distance(Pattern pattern, std::size_t count);

// Wraps an angle into the range from 0 to below 360 degrees.
double full_turn(double angle_deg);

} // namespace tractus::silhouette
