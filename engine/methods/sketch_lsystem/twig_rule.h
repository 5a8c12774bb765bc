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
    // The rule; letters as in rule.h. The values k, l, r, a, s and T are fitted; w and l_min are
    // scaled to the drawing, t is 180/k degrees, and the other values are defaults. Several twists
    // T give the same plant; this is the one nearest to 0.
    Rule rule;
    int order = 1;      // Levels of branching: 1 if only the axis bears laterals.
    int nodes = 0;      // Number of the axis's nodes that bear laterals.
    int bare_nodes = 0; // Number of the axis's nodes without laterals, below those that bear some.
    // Standard deviation of the drawn branching angles from the rule's.
    double angle_deviation_deg = 0;
    // Standard deviation of the laterals' relative lengths, as a share.
    double length_deviation = 0;
    // Root mean square distance of the laterals' feet from the rule's nodes, as a share of the
    // internode below the node.
    double spacing_deviation = 0;
    double twist_deviation_deg = 0;
    // Square root of the sum of squares of the four deviations above, with angles in radians and
    // the twist's deviation weighted by the sine of the branching angle; 0 for a perfect fit.
    double misfit = 0;

    // Maximum misfit at which the drawing counts as following a rule.
    static constexpr double kMaxMisfit = 0.4;
    bool is_rule() const { return misfit <= kMaxMisfit; }
};

// Finds the rule of a drawn twig. For each possible number of laterals per node and of bare nodes,
// positions, lengths and azimuths of the laterals are fitted by least squares (the inverse of Ijiri
// et al. 2006, section 3).
//
// Fails with a user error if the axis or a lateral is only a dot or not finite, if there are no
// laterals or too many, or if the fitted rule's internodes are out of range (check_rule()).
Result<TwigRule> find_twig_rule(DrawnTwig const& twig);

} // namespace tractus::sketch
