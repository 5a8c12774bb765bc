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
    // The model's derivation length when there is none. A model that is given its steps cannot
    // change their number by SetDerivationLength().
    std::optional<int> steps {};
    std::uint64_t seed = 1; // Together with the model's own: another seed, another plant.

    ModelLimits limits {};

    // Answers the modules ?E(…) of the axiom and of the string after each step; they keep their
    // parameters without. The rules of the next step see the answers.
    Environment environment {};

    // Takes what printf in rules and blocks prints; nothing does by default. Homomorphism rules
    // print when their modules are drawn (interpret.h).
    std::function<void(std::string_view text)> print {};

    // Long strings are rewritten in pieces of so many modules, several at a time; the string is the
    // same. The default stays in a processor's second cache and is worth a thread's while.
    std::size_t piece = 32'768;

    // Called with the axiom as step 0 and with the string after each step.
    std::function<void(int step, ModuleString const& string)> on_step {};
};

// Rewrites the model's axiom `steps` times. Query modules (query.h) are filled in the axiom and
// after each step.
//
// Fails, as the user's fault, beyond a limit, when a loop in the model does not end,
// or when a ?(…) calls a sub-L-system that the model does not have. The same model and options
// always give the same string.
Result<ModuleString> derive(Model const& model, DeriveOptions const& options = {});

} // namespace tractus::lsystem
