#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A model in cpfg's language that was translated from another program's notation.
struct ImportedModel {
    std::string text;
    std::string view;
    std::vector<std::string> warnings; // Features that were not translated, one sentence each.
};

// Translates a model in the notation of Laurens Lapre's LParser, versions 1 to 5. It consists of
// recursion depth, angle and thickness, the axiom, and rules X=STRING up to a line @; or of the
// same after the words recursion, angle, thickness, axiom and rule. # begins a comment.
//
// After each step the string has the same letters as in LParser, with two exceptions: letters that
// cannot be modules in cpfg are renamed, and there is one more module at its beginning and after
// each bracket. LParser's turtle keeps factors of length, angle and thickness ( " ' ; : ? ! ). A
// branch inherits these factors, and they are restored at its end. The model keeps them in arrays,
// which its homomorphism rules read and set. LParser's default length is 100 turtle units, and
// thickness is a percentage of that length. Random turns (~) differ from LParser's. The droop (t)
// is left out, with a warning.
//
// Fails with a user error "NAME:LINE: ..." for any other line.
Result<ImportedModel> read_lparser_model(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
