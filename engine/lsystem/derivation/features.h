#pragma once

#include "engine/lsystem/language/model.h"

#include <string>
#include <vector>

namespace tractus::lsystem {

// Returns what a model asks of the language, one phrase for each feature: "rules with parameters",
// "decomposition to depth 9", "3 organs: r, l, p". For people who want to know why a model behaves
// as it does, or whether another program would run it.
std::vector<std::string> features_used(Model const& model);

} // namespace tractus::lsystem
