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

// A plant of a document as built: its base plant, with strokes and indicators resolved on its
// segments.
struct BuiltPlant {
    // The state that the plant was built from; never null. Shared with the states of the document.
    std::shared_ptr<PlantState const> drawn = std::make_shared<PlantState const>();

    std::string model_name;
    // Warnings, each once, such as features of the model that are not supported.
    std::vector<std::string> model_warnings;

    // The plant as its source gives it, with added parts and without hidden branches. Never null;
    // has no branches as long as there is no source. Immutable, and shared between successive
    // scenes, the views and the threads that grow it.
    std::shared_ptr<Plant const> base = std::make_shared<Plant const>();
    variation::SharedRestShape rest {}; // The rest shape of `base`.
    // `foliated` is `base` with the leaves chosen for the plant. `in_season` is `foliated` in the
    // document's season: other organs on the same segments. Growth uses `in_season`.
    std::shared_ptr<Plant const> foliated = base;
    std::shared_ptr<Plant const> in_season = base;

    DeskPlacement placement; // Where the plant is shown in the drawing volume.
    DeskPlacement fitted;    // Placement that the plant would have as the only plant.
    SharedVector<std::vector<SegmentId>> selection;
    // Resolved strokes in drawing order: a later one overrides an earlier one. Each has one path.
    SharedList<Anchored<variation::Association>> associations;
    // Each indicator includes the segments below which it acts.
    std::vector<Anchored<variation::MotionIndicator>> indicators;
    SetGrowth growth;
};

// A document as built. The inherited members are those of the active plant.
struct Scene : BuiltPlant {
    DocumentState state {};
    // The built plants in the order of state.plants, including the active one. Immutable, and
    // shared with earlier and later scenes.
    std::vector<std::shared_ptr<BuiltPlant const>> plants {};
};

// Returns the indicators of a plant, without their addresses.
std::vector<variation::MotionIndicator> motion_indicators(BuiltPlant const& plant);

// Returns the indices, in order, of the associations that may affect a branch: those that are not
// orphaned and not overridden by a later one for the same path and propagation. After hours of
// drawing most associations are overridden. An overridden one takes effect again when the later one
// is deleted.
std::vector<std::size_t> shaping_numbers(BuiltPlant const& plant);

// Returns the associations of shaping_numbers().
std::vector<variation::Association> shaping_associations(BuiltPlant const& plant);

// Returns the paths of branches that the user drew: the paths of shaping_associations(), and the
// drawn limbs, each as its first segment.
std::vector<std::vector<SegmentId>> drawn_paths(BuiltPlant const& plant);

// Returns the indices of the strokes that the pen edits: those of shaping_numbers() whose path
// shares a segment with the selection.
std::vector<std::size_t> selected_associations(BuiltPlant const& plant);

// Returns the state after one more edit. Fails if a stroke has no shape, nothing is selected for an
// association, an id or number does not exist, or a value is out of range. Builds no plant, except
// for edits of sessions before format 4: see SceneBuilder::active_base().
Result<DocumentState> apply_edit(DocumentState state, Edit const& edit, SceneBuilder& builder);
Result<DocumentState> apply_edits(DocumentState state, std::span<Edit const> edits,
                                  SceneBuilder& builder);

// Returns the scene after one more edit, with its plants built. Also fails if a model does not
// compile or derive, or exceeds its limits, or if lines form no skeleton.
Result<Scene> apply_edit(Scene scene, Edit const& edit, MakeLoadOptions const& load_options = {});

// Returns the scene after several edits; its plants are built only once.
Result<Scene> apply_edits(Scene scene, std::span<Edit const> edits,
                          MakeLoadOptions const& load_options = {});

// Returns the scene that results from all edits, starting with an empty one.
Result<Scene> fold(std::span<Edit const> edits);

// Returns the scene in another season, or in none, as a preview before a SetSeason edit. Grown
// leaves that the document lacks for that season are approximated by their colour.
Scene preview_in_season(Scene scene, std::optional<Season> const& season);

// Returns the growth plan of a plant. Strokes and indicators are resolved once, and any number of
// variations can be grown from the plan. Fails like resolve_associations() and
// variation::plan_growth().
Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant);

} // namespace tractus::scene
