#pragma once

#include "engine/base/random.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::silhouette {

constexpr int kUsualWhorl = 3; // Branches at a node.
constexpr int kLeastWhorl = 2;
constexpr int kMostWhorl = 12;

// How branches stand around their parent.
struct Pattern {
    enum Kind {
        Even,      // As far from each other as they can be.
        Spiral,    // One at a node, 144 degrees on from the one below.
        Decussate, // Opposite pairs, each across the one below.
        Whorls,    // Several at a node, in the gaps of those below.
        TwoRows,   // One at a node, left and right in turn.
        Horizontal // Opposite pairs, all in the plane that was drawn in.
    } kind
        = Even;
    int whorl = kUsualWhorl; // At a node of whorls, kLeastWhorl to kMostWhorl; of others unused.

    constexpr Pattern() = default;
    constexpr Pattern(Kind of) // NOLINT(google-explicit-constructor): is one, with usual whorls.
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
    bool operator==(Kind of) const { return kind == of; } // Whatever its whorls are.
};

// "even", "spiral", "decussate", "whorls", "two-rows", "horizontal"; no value for other words.
std::optional<Pattern> pattern_of(std::string_view word);
char const* name_of(Pattern pattern);

// The pattern's name for people: "whorls of 5", but of three just "whorls".
std::string describe(Pattern pattern);

// A place on the unrolled parent: u from 0, its base, to 1; theta from 0 to below 360, 0 to the
// right and 180 to the left of the plane that was drawn in.
struct Place {
    double u = 0;
    double theta_deg = 0;
};

// A branch that was drawn keeps its u, and its theta stays near its side of the plane.
struct DrawnPlace {
    double u = 0;
    double theta_deg = 0; // 0 or 180.
    double most_off_deg = 45;
    bool keeps_u = true; // Else it moves to a node where nodes are whole.
};

struct ArrangementOptions {
    Pattern pattern = Pattern::Even;
    std::size_t count = 0; // Of all branches; those drawn at least.
    // Branches that are added stand from here on to the tip.
    double first_u = 0;
    // How fast closeness falls with distance; no value: 2 for each branch. The paper: 20.
    std::optional<double> alpha {};
    int proposals = 3000;
    // What nodes are to patterns that have any.
    enum class Nodes {
        Whole, // The branches of one stand there together (whole_whorls.h).
        Snap,  // What is added moves to the nearest one in the end. Some get more branches than the
               // pattern has, and others fewer.
        Free   // Branches stay beside them.
    } nodes
        = Nodes::Whole;
};

// What the search found.
struct Arrangement {
    std::vector<Place> places; // The drawn ones first, in their order.
    double cost_before = 0;
    double cost_after = 0; // Never more; both before what snaps does.
    int accepted = 0;      // Proposals.
};

// Spreads branches around their parent: a random one is offered a random place in its domain, and
// takes it if the sum over all pairs falls (depletion and replacement, Wither 2009 after Ripley).
// Pairs that are near cost, and those that do not fit the pattern. `key` names the random numbers.
Arrangement arrange(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                    RandomKey const& key);

// How little a pair fits a pattern whose nodes are `node` apart in u: 0 where it does, 1/2 at most.
double misfit(Pattern pattern, double node, Place const& a, Place const& b);

// How near a pair is: 1 at one place, less the faster the greater `alpha` is.
double closeness(double alpha, Place const& a, Place const& b);

// Shares of these in what a pair costs (Wither 2009: w1 and w2).
constexpr double kClosenessWeight = 2;
constexpr double kMisfitWeight = 1;

// How many branches stand at a node of a pattern; 1 where it has none.
std::size_t node_size(Pattern pattern);

// How far a pattern turns from a node to the next; 0 where it has none.
double node_turn_deg(Pattern pattern);

// How far a node is from the next, in u, of that many branches.
double node_distance(Pattern pattern, std::size_t count);

// An angle brought into the range from 0 to below 360.
double full_turn(double angle_deg);

} // namespace tractus::silhouette
