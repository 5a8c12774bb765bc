#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/grow.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/methods/self_organising/sag.h"

namespace tractus::self_organising {

constexpr int kMostYears = 200;

// One more year of a tree by itself: it grows by light, then sags under its weight. `surroundings`
// as grow_step() has them. Lengths in millimetres. Fails like grow_step().
Result<StepCount> grow_year(GrowingTree& tree, Surroundings& surroundings, Habit const& habit);

// A seedling that has grown by itself so many years, 1 to kMostYears. Fails, as the user's fault,
// for another number of years or a habit out of range, and like grow_step().
Result<GrowingTree> grow_by_itself(Habit const& habit, int years, std::uint64_t seed);

// Weights and stiffness for a habit.
SagLaws sag_laws(Habit const& habit);

} // namespace tractus::self_organising
