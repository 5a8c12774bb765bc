#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/model.h"
#include "engine/lsystem/module_string.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace tractus {

struct DeriveOptions {
    std::optional<int> steps {}; // The model's derivation length when there is none.
    std::uint64_t seed = 1;      // Together with the model's own: another seed, another plant.
    std::size_t max_modules = 100'000'000;

    // Called with the axiom as step 0 and with the string after each step.
    std::function<void(int step, ModuleString const& string)> on_step {};
};

// Rewrites the model's axiom `steps` times.
//
// Fails, as the user's fault, when the string grows beyond `max_modules` or a loop in the model
// does not end. The same model and options always give the same string.
Result<ModuleString> derive(Model const& model, DeriveOptions const& options = {});

// The string with every module replaced by what the homomorphism rules make of it: what the turtle
// reads. Fails as derive() does.
Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        std::size_t max_modules = 100'000'000);

} // namespace tractus
