#pragma once

#include "engine/base/result.h"
#include "engine/base/shared_list.h"
#include "engine/lsystem/limits.h"
#include "engine/scene/anchored.h"
#include "engine/scene/desk_placement.h"
#include "engine/scene/edit.h"
#include "engine/variation/growth_plan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// The document: what all edits so far amount to.
struct Scene {
    std::string model_name;
    std::vector<std::string> model_warnings; // Once each: what the model asks for that is not done.

    // The plant as the L-system gives it; never null, empty before the first model. Shared, and
    // changed by nobody, between the scenes of a fold, the views and the workers that grow it.
    std::shared_ptr<Plant const> base = std::make_shared<Plant const>();
    std::shared_ptr<RestShape const> rest = std::make_shared<RestShape const>(); // Of `base`.

    DeskPlacement placement; // Where the base plant is shown in the drawing volume.
    Selection selection;
    // In order: a later one overrides an earlier one. Each is at one path.
    SharedList<Anchored<Association>> associations;
    std::vector<Anchored<MotionIndicator>> indicators; // Each at the segments that it acts below.
    SetGrowth growth;

    std::uint64_t last_edit = 0; // The number of edits so far: of it, ids of items are made.
};

// The id of the first item that the edit at work makes: the one that it has already or, where that
// is 0, one that tells its number.
ItemId take_id(Scene& scene, ItemId own);

// Without their anchors.
std::vector<MotionIndicator> motion_indicators(Scene const& scene);

// The associations that some branch may still have its shape from, in order: neither orphaned nor
// followed by one for the same path and propagation. After hours of drawing they are few among all.
// The others count again when these are taken away. Their numbers.
std::vector<std::size_t> shaping_numbers(Scene const& scene);

// The same themselves.
std::vector<Association> shaping_associations(Scene const& scene);

// Those of them whose path has a segment in common with what is selected: their numbers. What the
// pen edits when it edits strokes.
std::vector<std::size_t> selected_associations(Scene const& scene);

// How a model is run when an edit loads it. Not part of the document: the plant does not depend on
// it, only whether there is one.
struct LoadOptions {
    ModelLimits limits {};
    std::function<void(std::string_view text)> print {}; // What the model prints; nowhere without.
};

// The scene after one more edit. Fails for a model that does not compile or derive, or not within
// its limits, lines that are no skeleton, a stroke that has no shape, an association when nothing
// is selected, or a number that nothing has. By value: a scene that is moved in is not copied.
Result<Scene> apply_edit(Scene scene, Edit const& edit, LoadOptions const& options = {});

// The scene that all edits amount to, beginning with an empty one.
Result<Scene> fold(std::span<Edit const> edits);

// The plan by which the scene's plants grow: its strokes and indicators resolved once, for any
// number of plants. Fails like resolve_associations and plan_growth.
Result<GrowthPlan> plan_growth(Scene const& scene);

} // namespace tractus
