#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/limits.h"
#include "engine/lsystem/model.h"
#include "engine/lsystem/module_string.h"

namespace tractus {

struct HomomorphismOptions {
    StringLimit limit {};
    TimeLimit time {};
};

// The string with every module replaced by what the homomorphism rules make of it, those of the
// L-system that is at work at its place: what the turtle reads. Fails, as the user's fault, beyond
// a limit in the options and when a loop does not end.
Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        HomomorphismOptions const& options = {});

} // namespace tractus
