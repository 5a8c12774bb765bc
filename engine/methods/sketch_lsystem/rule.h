#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <vector>

namespace tractus::sketch {

// The rule of a Sketch L-system (Ijiri, Owada, Igarashi, "The Sketch L-System: Global Control of
// Tree Modeling Using Free-form Strokes", Smart Graphics 2006, section 3), which grows along a
// stroke. At each step the top apex of the drawn axis becomes an internode, a ring of laterals and
// the next top apex, and each lateral apex becomes an internode and a ring of laterals of its own,
// without an apex that goes on.
//
// Lengths and diameters are in millimetres on the desk, angles in degrees. The letters are those
// that rule files use.
//
// Past the paper, laterals may have a rule of their own: then each is an axis that goes on,
// straight, with rings of laterals along it. Such rules are a list, and each says by its number
// which of them its laterals have: a later one, an earlier one, or itself. Where they call each
// other in a circle, the shortest internode and the plant's limit end it.
struct LateralRule {
    double length_ratio = 0.85;  // r: an internode, by the one before it on the lateral.
    double width_ratio = 0.85;   // q: the same for diameters.
    int laterals = 2;            // k: at each of its nodes.
    double angle_deg = 45;       // a: between its laterals and it.
    double lateral_length = 0.5; // s: a lateral's length, by its parent's.
    double lateral_width = 0.55; // v: the same for diameters.
    double twist_deg = 90;       // T: of the rings, from node to node.
    double shortest_mm = 3;      // l_min: no internode of it is shorter.
    int laterals_by = 0;         // by: number of its laterals' rule, from 1; 0: the next one.

    bool operator==(LateralRule const&) const = default;
};
constexpr std::size_t kMostLateralRules = 8;

struct Rule {
    double first_length_mm = 30; // l, 5 to 100: the drawn axis's first internode.
    double length_ratio = 0.9;   // r, 0.5 to 1.2: an internode of the axis, by the one before it.
    double width_ratio = 0.85;   // q, 0.3 to 1: the same for diameters.
    double first_width_mm = 4.5; // w, 0.02 to 0.5 of l: the first internode's diameter.

    int laterals = 2;             // k, 0 to 8: at each node, evenly around it.
    double angle_deg = 45;        // a, 0 to 150: between a lateral and its parent.
    double lateral_length = 0.62; // s, 0.2 to 1: a lateral's length, by its parent's.
    double lateral_width = 0.55;  // v, 0.2 to 1: the same for diameters.
    double axis_twist_deg
        = 90; // T, -180 to 180: of the rings, from node to node of the drawn axis.
    double lateral_twist_deg = 90; // t: the same on laterals.

    double shortest_mm = 1;           // l_min, above 0: no internode is shorter.
    int most_segments = 64;           // n_max, 1 to 10,000: of the drawn axis.
    double most_internodes = 200'000; // limit, n_max to 10 million: of the whole plant.

    // Rules of laterals, at most kMostLateralRules, in the ranges above: the first is that of the
    // drawn axis's. Where there is no next one, laterals fork as the paper's do, by the numbers of
    // the last. None: all do, by the numbers above.
    std::vector<LateralRule> lateral_rules {};

    bool operator==(Rule const&) const = default;
};

// Refuses, as the user's fault, a value that is not within the range above: one sentence with the
// letter, the value and the range.
Result<void> check_rule(Rule const& rule);

// A number as a model's text gives it: six significant digits, and no minus before a zero.
double as_written(double value);

// The rule with each number so. What follows from a rule is computed from this, so that the text
// says all of it.
Rule as_written(Rule const& rule);

// The place in the list of the rule that the laterals of the one at this place have; the list's
// size: they fork.
std::size_t lateral_rule_after(Rule const& rule, std::size_t place);

// How often laterals may fork where nothing has to be cut; one that goes on does so as often.
constexpr int kUncutDepth = 64;

// How many internodes a plant of `segments` segments has if laterals fork at most `depth` times;
// more than 2^53 is only roughly right, and may be infinite.
double count_internodes(Rule const& rule, int segments, int depth);

// The largest depth at which that is within the rule's limit: kUncutDepth if nothing has to be cut.
// While a stroke grows it only falls.
int depth_within_limit(Rule const& rule, int segments);

} // namespace tractus::sketch
