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
    // Number of derivation steps. A model cannot change a given number with SetDerivationLength().
    // Default: the model's derivation length.
    std::optional<int> steps {};
    // Seed of the derivation, combined with the model's own; different seeds give different plants.
    std::uint64_t seed = 1;

    ModelLimits limits {};

    // Answers the query modules ?E(...) of the axiom and of the string after each step; without an
    // environment they keep their parameters. The rules of the next step see the answers.
    Environment environment {};

    // Receives the output of printf in rules and blocks; by default it is discarded. Homomorphism
    // rules print while their modules are drawn (interpret.h).
    std::function<void(std::string_view text)> print {};

    // Long strings are rewritten in parallel in pieces of this many modules; the result does not
    // depend on it. The default fits into a processor's level 2 cache and is large enough to be
    // worth a thread's start.
    std::size_t piece = 32'768;

    // Callback that receives the axiom as step 0, then the string after each step.
    std::function<void(int step, ModuleString const& string)> on_step {};
};

// Derives a string: rewrites the model's axiom `steps` times. Query modules (query.h) are answered
// in the axiom and after each step.
//
// Fails with a user error if a limit is exceeded, if a loop in the model does not end, or if a
// ?(...) calls a sub-L-system that the model does not have. The same model and options always give
// the same string.
Result<ModuleString> derive(Model const& model, DeriveOptions const& options = {});

} // namespace tractus::lsystem
