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

// A base plant with the derived data that strokes and growth need. Immutable.
struct BasePlant {
    std::shared_ptr<Plant const> plant;
    variation::SharedRestShape rest;
    DeskPlacement fitted; // Placement as the only plant in the drawing volume.
    std::vector<std::string> warnings;
};

// Builds the plants of a document incrementally, since successive states are mostly equal. A plant
// is derived again only if its source has changed. Strokes are resolved again only if they or their
// plant have changed. Not thread-safe.
class SceneBuilder {
public:
    explicit SceneBuilder(MakeLoadOptions load_options = {});

    // Starts from a scene that has already been built.
    SceneBuilder(Scene const& scene, MakeLoadOptions load_options);

    // Builds the scene of a state. Fails if a source gives no plant.
    Result<Scene> build(DocumentState state);

    // After a failure: the number of the edit that set the failing source.
    std::uint64_t failed_edit() const { return failed_edit_; }

    // Returns the active plant without its strokes and indicators, or a plant without branches if
    // there is no active plant. Needed for edits of sessions before format 4, which refer to
    // segments by number instead of address.
    Result<std::shared_ptr<BasePlant const>> active_base(DocumentState const& state);

private:
    // Paths resolved so far in one base plant: their addresses and segments, by the id of the list
    // of addresses (SharedVector::id()).
    struct FoundPaths {
        variation::SharedRestShape rest;
        std::map<void const*, std::pair<SharedVector<PathAddress>, SharedVector<SegmentId>>> paths;
    };
    struct KnownBase {
        PlantSource source;
        std::shared_ptr<BasePlant const> base;
        // Parts and hidden branches, if the plant is composed (compose_base.h).
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
    std::list<KnownBase> bases_; // Known base plants, most recently used first.
    std::vector<std::shared_ptr<BuiltPlant const>> plants_;
    std::optional<Season> season_; // Season in which plants_ were built.
    LeafSheets leaf_sheets_;       // Leaf sheets with which plants_ were built.
    std::map<ItemId, FoundPaths> found_;
};

} // namespace tractus::scene
