#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <vector>

namespace tractus::sketch {

// The rules of a Sketch L-system, which grows along a stroke: Rule for the plant and LateralRule
// for its laterals (Ijiri, Owada, Igarashi, "The Sketch L-System: Global Control of Tree Modeling
// Using Free-form Strokes", Smart Graphics 2006, section 3). At each step the top apex of the drawn
// axis becomes an internode, a ring of laterals and the next top apex. Each lateral apex becomes an
// internode and a ring of laterals of its own and does not continue: it forks.
//
// Lengths and diameters are in millimetres on the desk, angles in degrees. The letters in the
// comments are those of rule files.
//
// As an extension of the paper, laterals may have rules of their own (LateralRule). Such a lateral
// is a straight axis that continues and bears rings of laterals. The lateral rules form a list;
// each names the rule of its own laterals, which may be a later one, an earlier one or itself.
// Where rules refer to each other in a circle, the minimum internode length and the limit on the
// plant's internodes end the growth.
struct LateralRule {
    double length_ratio = 0.85; // r: ratio of an internode's length to that of the one before it.
    double width_ratio = 0.85;  // q: ratio of an internode's diameter to that of the one before it.
    int laterals = 2;           // k: number of laterals at each node of the lateral.
    double angle_deg = 45;      // a: branching angle between the lateral and its own laterals.
    // s: ratio of a lateral's first internode to the parent's internode that bears it.
    double lateral_length = 0.5;
    double lateral_width = 0.55; // v: ratio of a lateral's diameter to its parent's.
    double twist_deg = 90;       // T: azimuth between successive rings of the lateral.
    double shortest_mm = 3;      // l_min: minimum length of an internode.
    // by: number of the rule for the lateral's own laterals, from 1; 0: the next rule in the list.
    int laterals_by = 0;

    bool operator==(LateralRule const&) const = default;
};
constexpr std::size_t kMaxLateralRules = 8;

struct Rule {
    double first_length_mm = 30; // l, 5 to 100: length of the drawn axis's first internode.
    // r, 0.5 to 1.2: ratio of an internode's length to that of the one before it.
    double length_ratio = 0.9;
    // q, 0.3 to 1: ratio of an internode's diameter to that of the one before it.
    double width_ratio = 0.85;
    double first_width_mm = 4.5; // w, 0.02 to 0.5 of l: diameter of the first internode.

    int laterals = 2;      // k, 0 to 8: number of laterals at each node, evenly around it.
    double angle_deg = 45; // a, 0 to 150: branching angle between a lateral and its parent.
    // s, 0.2 to 1: ratio of a lateral's first internode to the parent's internode that bears it.
    double lateral_length = 0.62;
    double lateral_width = 0.55; // v, 0.2 to 1: ratio of a lateral's diameter to its parent's.
    // T, -180 to 180: azimuth between successive rings of the drawn axis.
    double axis_twist_deg = 90;
    // t, -180 to 180: azimuth between successive rings of a lateral.
    double lateral_twist_deg = 90;

    double shortest_mm = 1; // l_min, above 0: minimum length of an internode.
    // o, 0 to 100: occupancy radius, mm. Laterals leave room for other parts of the drawn axis:
    // they stay short, or do not grow (lateral_room.h). 0: laterals ignore other parts.
    double occupancy_radius_mm = 0;
    int most_segments = 64; // n_max, 1 to 10,000: maximum number of segments of the drawn axis.
    // limit, n_max to 10 million: maximum number of internodes of the plant.
    double most_internodes = 200'000;

    // Rules of laterals, at most kMaxLateralRules, with values in the ranges that Rule gives for
    // the same letters. The first rule is for laterals of the drawn axis. Laterals that follow the
    // last rule fork, with the last rule's values. If the list is empty, all laterals fork, with
    // the values of this Rule.
    std::vector<LateralRule> lateral_rules {};

    bool operator==(Rule const&) const = default;
};

// Checks a rule. Fails with a user error for a value out of range; the message names the value's
// letter, the value and the range.
Result<void> check_rule(Rule const& rule);

// Rounds a number as a model's text shows it: to six significant digits, -0 to 0.
double rounded_as_text(double value);

// Rounds all numbers of a rule. Plants are computed from the rounded rule, so that the text of the
// rule describes the plant completely.
Rule rounded_as_text(Rule const& rule);

// Index in Rule::lateral_rules of the rule for laterals that are borne by laterals of rule `place`.
// The size of the list means that they fork.
std::size_t lateral_rule_after(Rule const& rule, std::size_t place);

// Maximum depth of a plant: how often its laterals fork, and how many internodes a lateral has that
// is an axis itself.
constexpr int kUncutDepth = 64;

// Number of internodes of a plant whose axis has `segments` segments and whose laterals fork at
// most `depth` times. Approximate above 2^53, and possibly infinite.
double count_internodes(Rule const& rule, int segments, int depth);

// The largest depth, at most kUncutDepth, at which a plant whose axis has `segments` segments stays
// within the rule's limit on internodes. More segments never give a larger depth.
int depth_within_limit(Rule const& rule, int segments);

} // namespace tractus::sketch
