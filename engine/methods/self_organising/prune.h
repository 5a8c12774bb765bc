#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"

#include <cstdint>
#include <span>

namespace tractus::self_organising {

// Cuts off what a ball touches on its way, as secateurs do: each internode that the ball comes near
// goes with all that it bears, down to the node below. Near each cut the lateral buds below it wake
// if they have died or their branches have been shed; they grow in the next step or die again. The
// wood below keeps its width. The lowest internode of the trunk, or of each stem, is never cut.
// `seed` drives the variation of the woken buds.
//
// Returns the number of internodes cut off. Fails with a user error for a ball without a radius.
Result<std::size_t> prune(GrowingTree& tree, std::span<BrushBall const> balls, Habit const& habit,
                          std::uint64_t seed);

} // namespace tractus::self_organising
