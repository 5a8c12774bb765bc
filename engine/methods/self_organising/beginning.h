#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <cstdint>
#include <memory>

namespace tractus::self_organising {

// A plant as it stood when a tree began to grow from it.
struct Beginning {
    std::shared_ptr<scene::PlantState const> plant; // With the strokes that bend it; not null.
    double scale = 0.1; // World millimetres per plant millimetre, for those strokes.
};
using SharedBeginning = std::shared_ptr<Beginning const>; // Shared by the tree's versions.

// The active plant of a document, or another one, as it stands. The builder gives the scale of a
// document that has none. Fails where a plant of it cannot be built.
Result<SharedBeginning> beginning_from(scene::DocumentState const& state, std::size_t number,
                                       scene::SceneBuilder& builder);

// The wood of a beginning. A tree that has grown by a habit keeps its buds; the axes of any other
// plant become wood as tree_of_wood() has it. Fails where the plant cannot be built, and for one
// without branches.
Result<GrowingTree> wood_of(Beginning const& beginning, Habit const& habit, std::uint64_t seed,
                            scene::LoadOptions const& options);

} // namespace tractus::self_organising
