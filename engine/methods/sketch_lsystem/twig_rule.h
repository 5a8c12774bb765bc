#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <cstddef>
#include <vector>

namespace tractus::sketch {

// A twig that somebody has drawn: an axis from its foot to its tip, and laterals in any order and
// direction, which begin on the axis or on other laterals. Millimetres; z is up, and what is drawn
// on a sheet has y = 0.
struct DrawnTwig {
    std::vector<Vec3> axis_mm;
    std::vector<std::vector<Vec3>> laterals_mm; // 1 to kMostTwigLaterals.
};
constexpr std::size_t kMostTwigLaterals = 200;

// The rule by which a twig would have grown.
struct TwigRule {
    // k, l, r, a, s and T are the twig's; widths and limits the usual ones. T is the one nearest to
    // 0 of those that look the same.
    Rule rule;
    int order = 1;      // How often laterals bear laterals: 1 where only the axis does.
    int nodes = 0;      // Of the axis, that bear something.
    int bare_nodes = 0; // Below them, without laterals.
    // Standard deviations of what was drawn from the rule.
    double angle_deviation_deg = 0;
    double length_deviation = 0;  // Of laterals' lengths, a share of them.
    double spacing_deviation = 0; // Of nodes' places, a share of the internode there.
    double twist_deviation_deg = 0;
    // Root mean square of all of these, radians and shares: 0 for a twig that is as the rule has
    // it.
    double misfit = 0;

    // A twig with a greater misfit has no such rule.
    static constexpr double kMostMisfit = 0.4;
    bool is_rule() const { return misfit <= kMostMisfit; }
};

// Finds the rule: the numbers of laterals at a node and of bare nodes are tried one by one, each
// with the least squares of places, lengths and turns of the laterals (Ijiri et al. 2006, section
// 3, read backwards).
//
// Fails, as the user's fault, for an axis or laterals that are only dots or not finite, without
// laterals, or with too many, and where the rule's internodes are out of range (check_rule()).
Result<TwigRule> find_twig_rule(DrawnTwig const& twig);

} // namespace tractus::sketch
