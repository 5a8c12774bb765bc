#pragma once

#include "engine/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace tractus::document {

// Memory that this program may use, in MiB: the smaller of the machine's and the container's.
std::uint64_t machine_memory_mb();

// Limits on running a model; a model that exceeds them is stopped with an error, so that it cannot
// take down the machine. The defaults depend on the machine.
struct ModelCost {
    std::size_t max_modules = lsystem::ModelLimits().max_modules;
    // Half, as the plant's geometry needs memory too.
    std::uint64_t max_memory_mb = machine_memory_mb() / 2;
    double max_seconds = 600; // Running time; 0: no limit.
    // Polled while models run and between a session's steps; returning true stops the work. May be
    // called from any thread. Empty: not polled.
    std::function<bool()> is_stopped {};
};

// Options for running a model within these limits; its time counts from now. The model's printed
// output goes to standard error, up to 100,000 characters.
scene::LoadOptions load_options(ModelCost const& cost = {});

// Returns a function that calls load_options(cost) for each plant, so that each has its own time
// limit.
scene::MakeLoadOptions make_load_options(ModelCost const& cost = {});

} // namespace tractus::document
