#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/twig_rule.h"

#include <filesystem>
#include <string>

namespace tractus::sketch {

// Reads a drawn twig from JSON, in millimetres: {"axis": [[x, y], …], "laterals": [[[x, y], …],
// …]}, x to the right and y up, or points [x, y, z] with z up. Fails with a user error that names
// the file, the place and what to write.
Result<DrawnTwig> load_twig(std::filesystem::path const& path);

// Formats the rule as a file for --rule (rule_file.h).
std::string print_rule_file(Rule const& rule);

// The rule inferred from a twig, as one line of JSON for other programs:
//
//   rule         {"k", "l", "r", "a", "s", "T", …}: the letters and units of rule files
//   laterals     k, laterals at each node
//   angle        a, degrees between a lateral and its parent
//   length_ratio s, a lateral's length divided by that of the internode below it
//   internode, internode_ratio   l, the axis's first internode in mm, and r, the ratio of each
//                internode to the one before it
//   divergence   T, degrees from node to node
//   order        how many levels of laterals there are, at least 1
//   nodes        nodes of the axis with laterals
//   bare_nodes   nodes below those, without laterals
//   deviations   {"angle", "length_ratio", "internode", "divergence"}: standard deviations of the
//                drawing from the rule, in degrees and shares
//   misfit       all deviations combined; 0 is a perfect fit
//   is_rule      false: no rule fits this twig
std::string print_twig_report(TwigRule const& twig);

} // namespace tractus::sketch
