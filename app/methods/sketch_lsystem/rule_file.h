#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::sketch {

// A rule from a small TOML file. Each number of sketch::Rule has the letter that stands beside it
// there: k, l, r, q, w, s, v, a, T, t, l_min, n_max and limit; a key that is missing keeps its
// default. Without w the first internode is 0.15 l thick, without T or t the rings turn by 180/k
// degrees.
//
//     k = 3       # laterals at a node
//     l = 30      # mm
//     a = 52      # degrees
//
// Tables [[laterals]] give laterals rules of their own, first those of the drawn axis's, with the
// letters of sketch::LateralRule and the same defaults:
//
//     [[laterals]]
//     k = 2
//     r = 0.9
//
// Fails, as the user's fault, with file and line: text that is no TOML, a key that does not exist,
// a value out of its range.
Result<Rule> parse_rule(std::string_view text, std::string const& name);

// Reads a rule from a file of at most 64 KiB. Fails like read_text_file() and parse_rule().
Result<Rule> load_rule(std::filesystem::path const& path);

} // namespace tractus::sketch
