#pragma once

#include "engine/base/result.h"
#include "engine/scene/document_state.h"
#include "engine/scene/scene.h"

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::scene {

// A base plant with what strokes and growth need of it. Nobody changes it.
struct BasePlant {
    std::shared_ptr<Plant const> plant;
    variation::SharedRestShape rest;
    DeskPlacement fitted; // As the only plant in the drawing volume.
    std::vector<std::string> warnings;
};

// Builds the plants of a document. States that follow each other share most of what they have: a
// plant is derived again only when its source has changed, and what was drawn is looked up again
// only where it or its plant has. Serves one caller at a time.
class SceneBuilder {
public:
    explicit SceneBuilder(MakeLoadOptions load_options = {});

    // One that has built this scene already.
    SceneBuilder(Scene const& scene, MakeLoadOptions load_options);

    // The scene of a state. Fails where a source gives no plant.
    Result<Scene> build(DocumentState state);

    // After a failure: the number of the edit which brought the source that gives none.
    std::uint64_t failed_edit() const { return failed_edit_; }

    // The active plant without what was drawn on it. Edits of sessions before format 4 say by its
    // segments what later ones say by places. Without plants one without branches.
    Result<std::shared_ptr<BasePlant const>> active_base(DocumentState const& state);

private:
    // The segments of paths that were looked up in one base plant, by the places' identity.
    struct FoundPaths {
        variation::SharedRestShape rest;
        std::map<void const*, std::pair<SharedVector<PathAddress>, SharedVector<SegmentId>>> paths;
    };
    struct KnownBase {
        PlantSource source;
        std::shared_ptr<BasePlant const> base;
        // Of one that was put together (compose_base.h).
        std::vector<Graft> grafts {};
        std::vector<SegmentAddress> hidden_branches {};

        bool is_of(PlantState const& plant) const
        {
            return source == plant.source && grafts == plant.grafts
                && hidden_branches == plant.hidden_branches;
        }
    };

    Result<std::shared_ptr<BasePlant const>> base_of(PlantState const& plant);
    Result<std::shared_ptr<BasePlant const>> base_of(PlantSource const& source,
                                                     std::uint64_t source_edit);
    BuiltPlant build(std::shared_ptr<PlantState const> const& drawn, BasePlant const& base,
                     DeskPlacement const& placement);
    void set_season(BuiltPlant& plant, BuiltPlant const* before, DocumentState const& state) const;
    void find_strokes(BuiltPlant& plant, BuiltPlant const* before);
    void find_selection(BuiltPlant& plant, BuiltPlant const* before);
    SharedVector<SegmentId> path_of(BuiltPlant const& plant, SharedVector<PathAddress> const& at);
    BuiltPlant const* built_before(PlantState const& plant) const;
    void forget_old_bases(DocumentState const& state);

    MakeLoadOptions load_options_;
    std::uint64_t failed_edit_ = 0;
    std::list<KnownBase> bases_; // The newest first.
    std::vector<std::shared_ptr<BuiltPlant const>> plants_;
    std::optional<Season> season_; // Of plants_, as the next one.
    LeafSheets leaf_sheets_;
    std::map<ItemId, FoundPaths> found_;
};

} // namespace tractus::scene
