#include "engine/scene/scene_builder.h"

#include "engine/scene/compose_base.h"
#include "engine/scene/foliated_plant.h"
#include "engine/scene/limb_edits.h"

#include <algorithm>
#include <utility>

namespace tractus::scene {

// Number of unused base plants to keep: undo may need them again.
static constexpr std::size_t kOldBases = 2;

static std::shared_ptr<BasePlant const> make_base(BuiltSource source)
{
    auto base = std::make_shared<BasePlant>();
    base->fitted = place_on_desk(source.plant);
    base->plant = std::make_shared<Plant const>(std::move(source.plant));
    base->rest = variation::SharedRestShape(base->plant, std::move(source.axis_keys));
    base->warnings = std::move(source.warnings);
    return base;
}

SceneBuilder::SceneBuilder(MakeLoadOptions load_options)
    : load_options_(std::move(load_options))
{
}

SceneBuilder::SceneBuilder(Scene const& scene, MakeLoadOptions load_options)
    : load_options_(std::move(load_options))
    , plants_(scene.plants)
    , season_(scene.state.season)
    , leaf_sheets_(scene.state.leaf_sheets)
{
    for (auto const& plant : plants_) {
        auto base = std::make_shared<BasePlant const>(
            BasePlant { plant->base, plant->rest, plant->fitted, plant->model_warnings });
        bases_.push_back({ plant->drawn->source, std::move(base), plant->drawn->grafts,
                           plant->drawn->hidden_branches });
        auto& found = found_[plant->drawn->id];
        found.rest = plant->rest;
        for (auto const& [id, association, at] : plant->associations)
            found.paths.emplace(at.id(), std::pair(at, association.path));
    }
}

Result<std::shared_ptr<BasePlant const>> SceneBuilder::base_of(PlantState const& plant)
{
    auto const known = std::find_if(bases_.begin(), bases_.end(),
                                    [&](KnownBase const& base) { return base.is_of(plant); });
    if (known != bases_.end()) {
        bases_.splice(bases_.begin(), bases_, known);
        return known->base;
    }
    auto own = TRY(base_of(plant.source, plant.source_edit));
    if (!is_composed(plant))
        return own;
    std::vector<std::shared_ptr<BasePlant const>> parts;
    for (auto const& graft : plant.grafts)
        parts.push_back(graft.limb ? nullptr : TRY(base_of(graft.source, graft.source_edit)));
    bases_.push_front(
        { plant.source, compose_base(plant, own, parts), plant.grafts, plant.hidden_branches });
    return bases_.front().base;
}

Result<std::shared_ptr<BasePlant const>> SceneBuilder::base_of(PlantSource const& source,
                                                               std::uint64_t source_edit)
{
    auto const known = std::find_if(bases_.begin(), bases_.end(), [&](KnownBase const& base) {
        return base.source == source && base.grafts.empty() && base.hidden_branches.empty();
    });
    if (known != bases_.end()) {
        bases_.splice(bases_.begin(), bases_, known);
        return known->base;
    }
    auto built = source.build(load_options_ ? load_options_() : LoadOptions {});
    if (!built) {
        failed_edit_ = source_edit;
        return tl::unexpected(built.error());
    }
    bases_.push_front({ source, make_base(*std::move(built)) });
    return bases_.front().base;
}

Result<std::shared_ptr<BasePlant const>> SceneBuilder::active_base(DocumentState const& state)
{
    auto const* const plant = active_plant(state);
    return plant ? base_of(*plant) : make_base({});
}

BuiltPlant const* SceneBuilder::built_before(PlantState const& plant) const
{
    auto const found = std::find_if(plants_.begin(), plants_.end(), [&](auto const& before) {
        return before->drawn->id == plant.id;
    });
    return found == plants_.end() ? nullptr : found->get();
}

Result<Scene> SceneBuilder::build(DocumentState state)
{
    std::vector<std::shared_ptr<BasePlant const>> bases;
    for (auto const& plant : state.plants)
        bases.push_back(TRY(base_of(*plant)));

    bool const is_same_season = state.season == season_ && state.leaf_sheets == leaf_sheets_;
    Scene scene;
    for (std::size_t i = 0; i < bases.size(); ++i) {
        auto const& drawn = state.plants[i];
        auto placement = bases[i]->fitted;
        rescale(placement, state.scale.value_or(bases.front()->fitted.scale));
        placement.origin_mm = drawn->stands_at_mm;
        auto const before = std::find_if(plants_.begin(), plants_.end(), [&](auto const& plant) {
            return plant->drawn == drawn && plant->placement.scale == placement.scale;
        });
        if (before != plants_.end() && is_same_season) {
            scene.plants.push_back(*before);
            continue;
        }
        auto plant = build(drawn, *bases[i], placement);
        set_season(plant, is_same_season ? built_before(*drawn) : nullptr, state);
        scene.plants.push_back(std::make_shared<BuiltPlant const>(std::move(plant)));
    }
    plants_ = scene.plants;
    season_ = state.season;
    leaf_sheets_ = state.leaf_sheets;
    forget_old_bases(state);
    if (auto const active = find_plant(state, state.active))
        static_cast<BuiltPlant&>(scene) = *scene.plants[*active];
    scene.state = std::move(state);
    return scene;
}

void SceneBuilder::forget_old_bases(DocumentState const& state)
{
    std::size_t old = 0;
    std::erase_if(bases_, [&](KnownBase const& base) {
        bool const is_own = base.grafts.empty() && base.hidden_branches.empty();
        auto const uses = [&](std::shared_ptr<PlantState const> const& plant) {
            if (!is_own)
                return base.is_of(*plant);
            return plant->source == base.source
                || std::any_of(plant->grafts.begin(), plant->grafts.end(),
                               [&](Graft const& graft) { return graft.source == base.source; });
        };
        bool const is_used = std::any_of(state.plants.begin(), state.plants.end(), uses);
        return !is_used && ++old > kOldBases;
    });
    std::erase_if(found_, [&](auto const& found) { return !find_plant(state, found.first); });
}

BuiltPlant SceneBuilder::build(std::shared_ptr<PlantState const> const& drawn,
                               BasePlant const& base, DeskPlacement const& placement)
{
    BuiltPlant plant;
    plant.drawn = drawn;
    plant.model_name = drawn->name;
    plant.model_warnings = base.warnings;
    plant.base = base.plant;
    plant.rest = base.rest;
    plant.fitted = base.fitted;
    plant.placement = placement;
    plant.growth = drawn->growth;
    plant.indicators = drawn->indicators;
    for (auto& [id, indicator, at] : plant.indicators) {
        for (auto const& place : at)
            if (auto const segment = plant.rest->addresses.find_segment(*plant.base, place.last))
                indicator.below.push_back(*segment);
        indicator.is_orphaned = indicator.below.empty() && !at.empty();
    }
    auto const* before = built_before(*drawn);
    if (before && before->base != plant.base)
        before = nullptr;
    find_strokes(plant, before);
    find_selection(plant, before);
    return plant;
}

// Sets the plant's leaves and season. `before` is the same plant as last built, if it was built in
// the same season; otherwise null.
void SceneBuilder::set_season(BuiltPlant& plant, BuiltPlant const* before,
                              DocumentState const& state) const
{
    if (before && before->base == plant.base && before->drawn->leaves == plant.drawn->leaves) {
        plant.foliated = before->foliated;
        plant.in_season = before->in_season;
        return;
    }
    auto const sheet = state.leaf_sheets.find(plant.drawn->leaves);
    plant.foliated = sheet == state.leaf_sheets.end()
        ? plant.base
        : std::make_shared<Plant const>(foliated(*plant.base, *sheet->second));
    plant.in_season = state.season ? std::make_shared<Plant const>(
                          in_season(*plant.foliated, *state.season, state.leaf_sheets))
                                   : plant.foliated;
}

// Returns the limbs of a plant with their axes. Limbs without segments are left out.
static std::vector<std::pair<DrawnLimb const*, AxisId>> limb_axes(BuiltPlant const& plant)
{
    std::vector<std::pair<DrawnLimb const*, AxisId>> axes;
    for (auto const& [graft, first] : limb_segments(plant))
        axes.emplace_back(graft->limb.get(), axis_of(*plant.base, first));
    return axes;
}

void SceneBuilder::find_strokes(BuiltPlant& plant, BuiltPlant const* before)
{
    auto const limbs = limb_axes(plant);
    auto const built = [&](Anchored<variation::ShapingStroke> const& drawn) {
        Anchored<variation::Association> association { drawn.id, {}, drawn.at };
        association.what = { .path = path_of(plant, drawn.at),
                             .stroke = drawn.what.stroke,
                             .propagation = drawn.what.propagation,
                             .fit = drawn.what.fit,
                             .detail_weight = drawn.what.detail_weight,
                             .laying = drawn.what.laying };
        for (auto const& [limb, axis] : limbs)
            if (auto const& older = limb->older_strokes;
                std::find(older.begin(), older.end(), drawn.id) != older.end())
                association.what.spared.push_back(axis);
        std::sort(association.what.spared.begin(), association.what.spared.end());
        association.what.is_orphaned = association.what.path.empty();
        return association;
    };
    static BuiltPlant const nothing;
    if (!before)
        before = &nothing;
    plant.associations
        = plant.drawn->strokes.map(before->drawn->strokes, before->associations, built);
}

void SceneBuilder::find_selection(BuiltPlant& plant, BuiltPlant const* before)
{
    auto const& wanted = plant.drawn->selection;
    if (before && before->drawn->selection.id() == wanted.id()) {
        plant.selection = before->selection;
        return;
    }
    variation::Selection paths;
    for (auto const& at : wanted)
        if (auto path = plant.rest->addresses.find_path(*plant.base, at))
            paths.push_back(*std::move(path));
    plant.selection = std::move(paths);
}

// Finds the segments at an address. Strokes at the same address share one list of segments.
SharedVector<SegmentId> SceneBuilder::path_of(BuiltPlant const& plant,
                                              SharedVector<PathAddress> const& at)
{
    auto& found = found_[plant.drawn->id];
    if (found.rest != plant.rest)
        found = { plant.rest, {} };
    auto const [entry, is_new] = found.paths.try_emplace(at.id());
    if (is_new) {
        entry->second.first = at;
        if (auto path = plant.rest->addresses.find_path(*plant.base, at.front()))
            entry->second.second = *std::move(path);
    }
    return entry->second.second;
}

} // namespace tractus::scene
