#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/derivation/query.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace tractus::lsystem {

struct DeriveOptions {
    // Number of derivation steps; the model cannot then change it with SetDerivationLength().
    // Default: the model's derivation length.
    std::optional<int> steps {};
    // Seed of the derivation, combined with the model's own seed. Different seeds give different
    // plants.
    std::uint64_t seed = 1;

    ModelLimits limits {};

    // Answers the query modules ?E(...) of the axiom, and of the string after each step. The rules
    // of the next step see the answers. Default: the environment that the model chooses; without
    // any, these modules keep their parameters.
    Environment environment {};

    // Receives the output of printf in rules and blocks; by default it is discarded. Homomorphism
    // rules do not print here but when their modules are drawn (interpret.h).
    std::function<void(std::string_view text)> print {};

    // Number of modules in the pieces in which long strings are rewritten in parallel; it does not
    // affect the result. A piece of the default size fits into a processor's level 2 cache and is
    // worth starting a thread for.
    std::size_t piece = 32'768;

    // Receives the axiom as step 0, and the string after each step.
    std::function<void(int step, ModuleString const& string)> on_step {};
};

// Derives a string: rewrites the model's axiom in as many steps as the derivation length. Query
// modules (query.h) are answered in the axiom and after each step.
//
// Fails with a user error if a limit is exceeded, if a loop in the model does not end, or if a
// ?(...) calls a sub-L-system that the model does not have. The same model and options always give
// the same string.
Result<ModuleString> derive(Model const& model, DeriveOptions const& options = {});

} // namespace tractus::lsystem
