#pragma once

#include "engine/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace tractus::document {

// Memory that this program may use, in MiB: the machine's memory or its container's limit,
// whichever is smaller.
std::uint64_t machine_memory_mb();

// Limits on running a model. A model that exceeds one of them is stopped with an error, so that it
// cannot make the machine unusable. The default memory limit depends on the machine.
struct ModelCost {
    std::size_t max_modules = lsystem::ModelLimits().max_modules;
    // Half of the available memory, because the plant's geometry needs memory too.
    std::uint64_t max_memory_mb = machine_memory_mb() / 2;
    double max_seconds = 600; // Running time; 0: no limit.
    // Polled while models run and between a session's steps. The work stops when the function
    // returns true. It may be called from any thread. Empty: not polled.
    std::function<bool()> is_stopped {};
};

// Options for running a model within the limits `cost`; its running time counts from this call. The
// model's printed output goes to standard error, up to 100,000 characters.
scene::LoadOptions load_options(ModelCost const& cost = {});

// Returns a function that calls load_options(cost) for each plant of a scene, so that each plant's
// model has the full running time.
scene::MakeLoadOptions make_load_options(ModelCost const& cost = {});

} // namespace tractus::document
