#pragma once

#include "engine/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace tractus::document {

// The memory that this program may use, in megabytes: the machine's, or the container's if it has
// less.
std::uint64_t machine_memory_mb();

// Limits at which a model is stopped with an error. The defaults suit the machine: a model that
// runs away must not take it down.
struct ModelCost {
    std::size_t max_modules = lsystem::ModelLimits().max_modules;
    std::uint64_t max_memory_mb = machine_memory_mb() / 2; // The plant needs memory, too.
    double max_seconds = 600;                              // 0: as long as it takes.
    // Asked while models run and between a session's steps: true stops, from any thread. Empty:
    // nothing else stops them.
    std::function<bool()> is_stopped {};
};

// How to run a model that may cost so much from now on. What it prints goes to standard error, up
// to 100,000 characters.
scene::LoadOptions load_options(ModelCost const& cost = {});

// Gives load_options(cost) anew for each plant: its time counts from when it is built.
scene::MakeLoadOptions make_load_options(ModelCost const& cost = {});

} // namespace tractus::document
