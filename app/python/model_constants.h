#pragma once

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::python {

using Constants = std::map<std::string, double, std::less<>>;

// Returns the constants of a model's rules: the macros without parameters that stand for a number,
// as in "#define ANGLE 30". If a name is defined several times, its last number counts.
Constants constants_of(std::string_view rules);

// Returns the rules with other numbers for some of their constants, wherever these are defined.
// Everything else, such as comments, is unchanged. Fails with a user error that begins with `name`
// if there is no such constant or a number is not finite.
Result<std::string> with_constants(std::string const& name, std::string_view rules,
                                   Constants const& constants);

} // namespace tractus::python
