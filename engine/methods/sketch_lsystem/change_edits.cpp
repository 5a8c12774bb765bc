#include "engine/methods/sketch_lsystem/change_edits.h"

#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::sketch {

namespace {

template<typename Grafts> auto find_graft(Grafts& grafts, scene::ItemId part)
{
    return std::find_if(grafts.begin(), grafts.end(), [&](scene::Graft const& graft) {
        return graft.prefix == part_prefix(part);
    });
}

Result<GrowAlongStroke> sketch_in(scene::PlantState const& plant, scene::ItemId part)
{
    GrowAlongStroke const* sketch = nullptr;
    if (part == 0)
        sketch = sketch_of(plant.source);
    else if (auto const graft = find_graft(plant.grafts, part); graft != plant.grafts.end())
        sketch = sketch_of(graft->source);
    if (!sketch)
        return fail(Fault::User,
                    fmt::format("plant {} has nothing any more that grew along that stroke",
                                scene::name_of(plant.id)));
    return *sketch;
}

// Applies `change` to the plant or grafted part that `edit` names, and returns the document with
// the changed plant.
template<typename Edit, typename Change>
Result<scene::DocumentState> changed(scene::DocumentState state, Edit const& edit,
                                     Change const& change)
{
    auto const number = TRY(scene::plant_number(state, edit.plant));
    auto sketch = TRY(sketch_in(*state.plants[number], edit.part));
    TRY(change(sketch));
    TRY(drawn_nodes_mm(sketch));
    scene::change_plant(state, number, [&](scene::PlantState& plant) {
        auto const graft = find_graft(plant.grafts, edit.part);
        auto& source = edit.part == 0 ? plant.source : graft->source;
        auto& source_edit = edit.part == 0 ? plant.source_edit : graft->source_edit;
        source = source_of(sketch);
        source_edit = state.last_edit;
        plant.selection.clear();
    });
    return state;
}

void list(scene::Fields& fields, ChangeSketch& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("part", &edit.part);
    list_rule(fields, edit.rule);
    fields.word("leaves", edit.leaves, kLeavesWords);
    list_model(fields, edit.model);
}

Result<scene::DocumentState> applied(scene::DocumentState state, ChangeSketch const& edit,
                                     scene::SceneBuilder&)
{
    return changed(std::move(state), edit, [&](GrowAlongStroke& sketch) {
        sketch.rule = edit.rule;
        sketch.leaves = edit.leaves;
        sketch.model = edit.model;
        return Result<void> {};
    });
}

std::string described(ChangeSketch const& edit)
{
    if (edit.model.is_set())
        return fmt::format("lets another model grow along the stroke of {}",
                           scene::name_of(edit.part == 0 ? edit.plant : edit.part));
    return fmt::format("changes the rule of {} to {} at {:g} degrees",
                       scene::name_of(edit.part == 0 ? edit.plant : edit.part),
                       scene::counted(static_cast<std::size_t>(edit.rule.laterals), "lateral"),
                       edit.rule.angle_deg);
}

void list(scene::Fields& fields, ShortenSketch& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("part", &edit.part);
    fields.field("tips", &edit.tips);
}

Result<scene::DocumentState> applied(scene::DocumentState state, ShortenSketch const& edit,
                                     scene::SceneBuilder&)
{
    return changed(std::move(state), edit, [&](GrowAlongStroke& sketch) -> Result<void> {
        auto const tips = TRY(sketch.stroke.tips.in_memory());
        auto const kept = std::min<std::uint64_t>(edit.tips, tips.size());
        sketch.stroke.tips
            = std::vector(tips.begin(), tips.begin() + static_cast<std::ptrdiff_t>(kept));
        return {};
    });
}

void list(scene::Fields& fields, RedrawSketch& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("part", &edit.part);
    fields.word("surface", edit.surface, kSurfaceWords);
    fields.sparse_field("turned_round", &edit.is_drawn_reversed);
    fields.numbers(edit.stroke);
}

Result<scene::DocumentState> applied(scene::DocumentState state, RedrawSketch const& edit,
                                     scene::SceneBuilder&)
{
    state = TRY(changed(std::move(state), edit, [&](GrowAlongStroke& sketch) {
        sketch.stroke = edit.stroke;
        sketch.surface = edit.surface;
        sketch.is_drawn_reversed = edit.is_drawn_reversed;
        return Result<void> {};
    }));
    if (edit.part != 0)
        return state;
    scene::change_plant(state, TRY(scene::plant_number(state, edit.plant)),
                        [&](scene::PlantState& plant) {
                            auto const& sketch = *sketch_of(plant.source);
                            plant.stands_at_mm = stands_at_mm(sketch);
                            plant.paper_mm = paper_position_mm(sketch);
                        });
    return state;
}

std::string described(RedrawSketch const& edit)
{
    return fmt::format("draws the stroke of {} again: {}",
                       scene::name_of(edit.part == 0 ? edit.plant : edit.part),
                       scene::describe_stroke(edit.stroke));
}

std::string described(ShortenSketch const& edit)
{
    return fmt::format("shortens the stroke of {} to {}",
                       scene::name_of(edit.part == 0 ? edit.plant : edit.part),
                       scene::counted(edit.tips, "tip"));
}

} // namespace

std::vector<GrownPart> all_grown(scene::PlantState const& plant)
{
    std::vector<GrownPart> grown;
    for (auto graft = plant.grafts.rbegin(); graft != plant.grafts.rend(); ++graft)
        if (auto const* const sketch = sketch_of(graft->source);
            sketch && graft->prefix == part_prefix(part_of(graft->prefix)))
            grown.push_back({ part_of(graft->prefix), sketch });
    if (auto const* const sketch = sketch_of(plant.source))
        grown.push_back({ 0, sketch });
    return grown;
}

std::optional<GrownPart> newest_grown(scene::PlantState const& plant)
{
    auto const grown = all_grown(plant);
    return grown.empty() ? std::nullopt : std::optional(grown.front());
}

Result<std::optional<std::size_t>> count_tips(GrowAlongStroke const& sketch, std::size_t segments)
{
    auto const tips = TRY(sketch.stroke.tips.in_memory());
    StrokeResampler resampler(TRY(lengths_of(sketch)));
    std::size_t count = 0;
    for (auto const& tip_mm : plant_tips(tips.vector(), sketch.surface)) {
        ++count;
        resampler.push(tip_mm);
        if (static_cast<std::size_t>(resampler.segments()) >= segments)
            return count;
    }
    return std::nullopt;
}

constexpr scene::EditKind ChangeSketch::kKind
    = scene::make_edit_kind<ChangeSketch, list, applied, described>("change_sketch", true);
constexpr scene::EditKind ShortenSketch::kKind
    = scene::make_edit_kind<ShortenSketch, list, applied, described>("shorten_sketch", true);
constexpr scene::EditKind RedrawSketch::kKind
    = scene::make_edit_kind<RedrawSketch, list, applied, described>("redraw_sketch", true);

} // namespace tractus::sketch
