#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/twig_rule.h"

#include <filesystem>
#include <string>

namespace tractus::sketch {

// Reads a twig from JSON, millimetres: {"axis": [[x, y], …], "laterals": [[[x, y], …], …]}, x to
// the right and y up, or [x, y, z] with z up. Fails, as the user's fault, with file, place and what
// to write.
Result<DrawnTwig> load_twig(std::filesystem::path const& path);

// The rule as a file for --rule (rule_file.h).
std::string print_rule_file(Rule const& rule);

// What a twig amounts to, as one line of JSON for other programs:
//
//   rule         {"k", "l", "r", "a", "s", "T", …}: the letters and units of rule files
//   laterals     k, at each node
//   angle        a, degrees between a lateral and its parent
//   length_ratio s, a lateral's length by the internode below it
//   internode, internode_ratio   l, the axis's first one in mm, and r, each by the one before it
//   divergence   T, degrees from node to node
//   order        how often laterals bear laterals, from 1
//   nodes        of the axis, that bear laterals; bare_nodes: below them, without
//   deviations   {"angle", "length_ratio", "internode", "divergence"}: standard deviations of what
//   was
//                drawn from the rule, degrees and shares
//   misfit       all of these together, 0: none
//   is_rule      false: no rule makes this twig
std::string print_twig_report(TwigRule const& twig);

} // namespace tractus::sketch
