#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::sketch {

// Reads a rule from TOML. The keys are the letters given in the comments of sketch::Rule: k, l, r,
// q, w, s, v, a, T, t, l_min, n_max, limit and o. Missing keys have the defaults of sketch::Rule,
// but w defaults to 0.15 l, and T and t to 180/k degrees.
//
//     k = 3       # laterals at a node
//     l = 30      # mm
//     a = 52      # degrees
//
// Tables [[laterals]] are the rules for laterals (Rule::lateral_rules); the first applies to the
// laterals of the drawn axis. The keys are the letters given in the comments of LateralRule.
// Missing keys have the defaults of LateralRule, but T defaults to 180/k degrees:
//
//     [[laterals]]
//     k = 2
//     r = 0.9
//
// Fails with a user error that names the file and line: invalid TOML, an unknown key, or a value
// out of its range.
Result<Rule> parse_rule(std::string_view text, std::string const& name);

// Reads a rule from a file. Fails with a user error if the file cannot be read, exceeds 64 KiB or
// is invalid.
Result<Rule> load_rule(std::filesystem::path const& path);

} // namespace tractus::sketch
