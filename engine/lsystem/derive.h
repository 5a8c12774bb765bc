#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/model.h"
#include "engine/lsystem/module_string.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace tractus {

struct DeriveOptions {
    std::optional<int> steps; // The model's derivation length when there is none.
    std::uint64_t seed = 1;   // Together with the model's own: another seed, another plant.
    std::size_t max_modules = 100'000'000;
};

// Rewrites the model's axiom `steps` times.
//
// Fails, as the user's fault, when the string grows beyond `max_modules` or a loop in the model does
// not end. The same model and options always give the same string.
Result<ModuleString> derive(Model const& model, DeriveOptions const& options = {});

} // namespace tractus
