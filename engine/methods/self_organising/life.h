#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/grow.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/methods/self_organising/sag.h"

namespace tractus::self_organising {

constexpr int kMaxYears = 200;

// Grows a tree for one more year without a brush: its buds compete for light, then its branches sag
// under their weight. `surroundings` are passed to grow_step(). Lengths are in millimetres. Fails
// like grow_step().
Result<StepCount> grow_year(GrowingTree& tree, Surroundings& surroundings, Habit const& habit);

// Grows a tree from a seedling for `years` years without a brush, 1 to kMaxYears. Fails with a
// user error for another number of years or a habit out of range, and like grow_step().
Result<GrowingTree> grow_without_brush(Habit const& habit, int years, std::uint64_t seed);

// The weights of a habit's wood and leaves, and the stiffness of its wood.
SagLaws sag_laws(Habit const& habit);

} // namespace tractus::self_organising
