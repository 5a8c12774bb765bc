#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"

#include <cstdint>
#include <span>

namespace tractus::self_organising {

// Prunes a tree along the path of a ball, as secateurs do: each internode that the ball touches is
// removed, with everything above it. Below each cut, lateral buds that have died or whose branches
// have been shed wake; they grow in the next step or die again. The wood below the cuts keeps its
// width. The lowest internode of the trunk, or of each stem, is never cut. `seed` drives the
// variation of the woken buds.
//
// Returns the number of internodes removed. Fails with a user error for a ball without a radius.
Result<std::size_t> prune(GrowingTree& tree, std::span<BrushBall const> balls, Habit const& habit,
                          std::uint64_t seed);

} // namespace tractus::self_organising
