#pragma once

#include "engine/lsystem/language/model.h"

#include <string>
#include <vector>

namespace tractus::lsystem {

// Lists the language features that a model uses, one phrase each: "rules with parameters",
// "decomposition to depth 9", "3 organs: r, l, p". The list helps to explain a model's behaviour,
// or to see whether another program can run the model.
std::vector<std::string> features_used(Model const& model);

} // namespace tractus::lsystem
