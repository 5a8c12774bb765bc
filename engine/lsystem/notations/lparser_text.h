#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A model in cpfg's language, made from one in another program's notation.
struct ImportedModel {
    std::string text;
    std::string view;
    std::vector<std::string> warnings; // What the model has lost, one sentence each.
};

// Translates a model in the notation of Laurens Lapre's LParser, versions 1 to 5: recursion depth,
// angle and thickness, the axiom, and rules X=STRING up to a line @; or these with the words
// recursion, angle, thickness, axiom and rule. # begins a comment.
//
// The string has the same letters after each step, those that cpfg cannot have as modules under
// another name, and a module more at its beginning and after each bracket. LParser's turtle keeps
// factors of length, angle and thickness ( " ' ; : ? ! ), which branches inherit and give back:
// the model keeps them in arrays that its homomorphism reads and sets. LParser's default length is
// 100 turtle units, and thickness is a percentage of it. Randomness (~) is drawn anew here; the
// droop (t) is left out, with a warning.
//
// Fails with a user error "NAME:LINE: ...", if a line is none of these.
Result<ImportedModel> read_lparser_model(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
