#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::sketch {

// A rule from a small TOML file. Each number of sketch::Rule has the letter given in its comment
// there: k, l, r, q, w, s, v, a, T, t, l_min, n_max and limit. Missing keys keep their defaults,
// but w defaults to 0.15 l, and T and t to 180/k degrees.
//
//     k = 3       # laterals at a node
//     l = 30      # mm
//     a = 52      # degrees
//
// Tables [[laterals]] give laterals rules of their own, the laterals of the drawn axis first. They
// have the letters of sketch::LateralRule and the same defaults:
//
//     [[laterals]]
//     k = 2
//     r = 0.9
//
// Fails with a user error that names the file and line: invalid TOML, an unknown key, or a value
// out of its range.
Result<Rule> parse_rule(std::string_view text, std::string const& name);

// Reads a rule from a file of at most 64 KiB. Fails like read_text_file() and parse_rule().
Result<Rule> load_rule(std::filesystem::path const& path);

} // namespace tractus::sketch
