#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <cstddef>
#include <vector>

namespace tractus::sketch {

// A drawn twig: an axis from its foot to its tip, and laterals in any order and direction that
// begin on the axis or on other laterals. Coordinates are in millimetres; z is up, and a twig drawn
// on a sheet has y = 0.
struct DrawnTwig {
    std::vector<Vec3> axis_mm;
    std::vector<std::vector<Vec3>> laterals_mm; // From 1 to kMaxTwigLaterals laterals.
};
constexpr std::size_t kMaxTwigLaterals = 200;

// The rule that fits a drawn twig best.
struct TwigRule {
    // The rule. Its k, l, r, a, s and T are fitted; w and l_min are scaled to the drawing, t is
    // 180/k degrees, and the other values are defaults. T is, of all equivalent twists, the one
    // nearest to 0.
    Rule rule;
    int order = 1;      // Levels of branching: 1 if only the axis bears laterals.
    int nodes = 0;      // Number of the axis's nodes that bear laterals.
    int bare_nodes = 0; // Number of the axis's nodes without laterals, below those that bear some.
    // Standard deviations of the drawing from the rule: here, of branching angles.
    double angle_deviation_deg = 0;
    double length_deviation = 0; // Relative deviation of the laterals' lengths.
    // Deviation of the nodes' positions along the axis, relative to the internode there.
    double spacing_deviation = 0;
    double twist_deviation_deg = 0;
    // Root of the sum of squares of the deviations above, in radians and shares, with the twist's
    // weighted by the sine of the branching angle; 0 for a perfect fit.
    double misfit = 0;

    // A twig with a greater misfit does not follow such a rule.
    static constexpr double kMaxMisfit = 0.4;
    bool is_rule() const { return misfit <= kMaxMisfit; }
};

// Finds the rule of a drawn twig. All numbers of laterals per node and of bare nodes are tried,
// each with a least-squares fit of positions, lengths and azimuths of the laterals (the inverse of
// Ijiri et al. 2006, section 3).
//
// Fails with a user error if the axis or a lateral is only a dot or not finite, if there are no
// laterals or too many, or if the rule's internodes are out of range (check_rule()).
Result<TwigRule> find_twig_rule(DrawnTwig const& twig);

} // namespace tractus::sketch
