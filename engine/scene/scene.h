#pragma once

#include "engine/base/result.h"
#include "engine/base/shared_list.h"
#include "engine/scene/anchored.h"
#include "engine/scene/desk_placement.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/rest_shape.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::scene {

// A plant of a document as it is built: its base plant, and what was drawn on it, found there.
struct BuiltPlant {
    // What it was built from; never null. Shared with the document's states.
    std::shared_ptr<PlantState const> drawn = std::make_shared<PlantState const>();

    std::string model_name;
    std::vector<std::string> model_warnings; // Once each: what the model asks for that is not done.

    // The plant as its source gives it; never null, empty before there is one. Shared, and changed
    // by nobody, between scenes that follow each other, the views and the workers that grow it.
    std::shared_ptr<Plant const> base = std::make_shared<Plant const>();
    variation::SharedRestShape rest {}; // Of `base`.
    // `base` with the leaves that the plant is to have; and so in the document's season: with other
    // organs on the same segments. The latter grows.
    std::shared_ptr<Plant const> dressed = base;
    std::shared_ptr<Plant const> in_season = base;

    DeskPlacement placement; // Where it is shown in the drawing volume,
    DeskPlacement fitted;    // and where it would be as the only plant.
    SharedVector<std::vector<SegmentId>> selection;
    // In order: a later one overrides an earlier one. Each is at one path.
    SharedList<Anchored<variation::Association>> associations;
    // Each at the segments that it acts below.
    std::vector<Anchored<variation::MotionIndicator>> indicators;
    SetGrowth growth;
};

// A document as it is built. What is said of one plant is the active one's.
struct Scene : BuiltPlant {
    DocumentState state {};
    // In the order of the state, the active one among them. Nobody changes one: they are shared
    // with the scenes before and after.
    std::vector<std::shared_ptr<BuiltPlant const>> plants {};
};

// Without their anchors.
std::vector<variation::MotionIndicator> motion_indicators(BuiltPlant const& plant);

// The associations that some branch may still have its shape from, in order: neither orphaned nor
// followed by one for the same path and propagation. After hours of drawing they are few among all.
// The others count again when these are taken away. Their numbers.
std::vector<std::size_t> shaping_numbers(BuiltPlant const& plant);

// These associations themselves.
std::vector<variation::Association> shaping_associations(BuiltPlant const& plant);

// Those of them whose path has a segment in common with what is selected: their numbers. What the
// pen edits when it edits strokes.
std::vector<std::size_t> selected_associations(BuiltPlant const& plant);

// The state after one more edit. Fails for a stroke that has no shape, an association when nothing
// is selected, an id or number that nothing has, or a value out of range. Builds no plant but for
// edits of sessions before format 4: see SceneBuilder::active_base().
Result<DocumentState> apply_edit(DocumentState state, Edit const& edit, SceneBuilder& builder);
Result<DocumentState> apply_edits(DocumentState state, std::span<Edit const> edits,
                                  SceneBuilder& builder);

// The scene after one more edit, its plants built. Fails, too, for a model that does not compile or
// derive, or not within its limits, and for lines that are no skeleton.
Result<Scene> apply_edit(Scene scene, Edit const& edit, MakeLoadOptions const& load_options = {});

// The scene after edits that belong together, whose plants are built once.
Result<Scene> apply_edits(Scene scene, std::span<Edit const> edits,
                          MakeLoadOptions const& load_options = {});

// The scene that all edits amount to, beginning with an empty one.
Result<Scene> fold(std::span<Edit const> edits);

// The scene as it would be in another season, or without one, before that is an edit: grown leaves
// that the document does not have for it are told from their colour alone.
Scene preview_in_season(Scene scene, std::optional<Season> const& season);

// The plan by which variations of a plant grow: its strokes and indicators resolved once, for any
// number of plants. Fails like resolve_associations and plan_growth.
Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant);

} // namespace tractus::scene
