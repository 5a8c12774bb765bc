#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::self_organising {

// The plant from which a self-organising tree continues to grow, as it was when this growth began.
// Any method may have made the plant.
struct Beginning {
    // The plant together with the strokes that bend it; not null.
    std::shared_ptr<scene::PlantState const> plant;
    // World millimetres per plant millimetre; relates the strokes, which are in the world frame, to
    // the plant.
    double scale = 0.1;
    // Keys of the axes that are kept; their ancestors are kept with them. Empty: all axes are kept.
    std::vector<std::uint32_t> kept_axes {};
    // True: lateral buds all over the wood are awake, for growth along a brush. False: only those
    // on young wood (GivenWood::Buds).
    bool wakes_buds = false;
};
// A shared pointer, because all versions of a tree in the undo history have the same beginning.
using SharedBeginning = std::shared_ptr<Beginning const>;

// Makes a beginning from the plant at index `number` of a document. `builder` supplies the scale if
// the document has none. Fails if a plant of that document cannot be built.
Result<SharedBeginning> beginning_from(scene::DocumentState const& state, std::size_t number,
                                       std::vector<std::uint32_t> kept_axes, bool wakes_buds,
                                       scene::SceneBuilder& builder);

// Builds the growing tree of a beginning. A self-organising tree whose axes are all kept keeps its
// buds, too; the axes of any other plant become wood (tree_from_wood()). Fails if the plant cannot
// be built or has no branches, or if it has none of the axes to keep.
Result<GrowingTree> tree_from_beginning(Beginning const& beginning, Habit const& habit,
                                        std::uint64_t seed, scene::LoadOptions const& options);

// Points on the wood of a beginning's plant, in its shape after bending by strokes, at most
// `step_mm` apart along each branch; in plant millimetres. Fails if the plant cannot be built.
Result<std::vector<Vec3>> points_on_wood(Beginning const& beginning, double step_mm,
                                         scene::LoadOptions const& options);

} // namespace tractus::self_organising
