#include "engine/methods/leaves/leaf_sketch_edits.h"

#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/scene/paper.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

void list(scene::Fields& fields, LeafForm& form)
{
    fields.field("bend_deg", &form.bend_deg);
    fields.field("rise_deg", &form.rise_deg);
    fields.field("vein_curve_deg", &form.vein_curve_deg);
    fields.field("vein_width", &form.vein_width);
    fields.field("teeth", &form.teeth);
    fields.field("tooth_depth", &form.tooth_depth);
    fields.field("variation", &form.variation);
}

void list(scene::Fields& fields, AddLeafLine& edit)
{
    fields.sparse_field("plant", &edit.plant);
    fields.sparse_field("may_be_leaflet", &edit.may_be_leaflet);
    list(fields, edit.form);
    fields.field("scale", &edit.scale);
    fields.field("stands_at_mm", &edit.stands_at_mm);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<LeafSketch> find_leaf(scene::DocumentState const& state, scene::ItemId plant)
{
    auto const number = TRY(scene::plant_number(state, plant));
    auto const* const sketch = leaf_sketch(*state.plants[number]);
    if (!sketch)
        return fail(Fault::User,
                    fmt::format("plant {} is no drawn leaf: begin another leaf with its outline",
                                scene::name_of(plant)));
    return *sketch;
}

// Replaces the leaf sketch of a plant. If the leaf's foot on the paper moves, the plant moves with
// it, so that it stays beneath the drawn lines. Fails if the new sketch gives no plant.
Result<scene::DocumentState> with_leaf(scene::DocumentState state, scene::ItemId plant,
                                       LeafSketch sketch)
{
    TRY(build_leaf(sketch));
    auto const foot_mm = TRY(foot_of(sketch));
    scene::redraw_on_paper(state, TRY(scene::plant_number(state, plant)),
                           scene::PlantSource(LeafSketch::kKind, std::move(sketch)), foot_mm);
    return state;
}

Result<scene::DocumentState> begun(scene::DocumentState state, AddLeafLine const& edit)
{
    if (!edit.stands_at_mm.allFinite())
        return fail(Fault::User, "the place for the leaf is not a number: draw it again");
    auto const id = scene::take_id(state, edit.id);
    auto sketch = TRY(
        with_line({ .form = edit.form, .scale = edit.scale },
                  { .id = id, .stroke = edit.stroke, .may_be_leaflet = edit.may_be_leaflet }));
    TRY(build_leaf(sketch));
    auto const foot_mm = TRY(foot_of(sketch));
    if (!state.scale)
        state.scale = edit.scale;
    return scene::with_source(std::move(state),
                              { .name = "leaf",
                                .source = scene::PlantSource(LeafSketch::kKind, std::move(sketch)),
                                .drawn = scene::Drawn::Beside,
                                .stands_at_mm = edit.stands_at_mm,
                                .paper_mm = foot_mm,
                                .id = id });
}

Result<scene::DocumentState> applied(scene::DocumentState state, AddLeafLine const& edit,
                                     scene::SceneBuilder&)
{
    if (edit.plant == 0)
        return begun(std::move(state), edit);
    auto sketch = TRY(find_leaf(state, edit.plant));
    sketch = TRY(with_line(std::move(sketch),
                           { .id = scene::take_id(state, edit.id),
                             .stroke = edit.stroke,
                             .may_be_leaflet = edit.may_be_leaflet }));
    return with_leaf(std::move(state), edit.plant, std::move(sketch));
}

std::string described(AddLeafLine const& edit)
{
    if (edit.plant == 0)
        return fmt::format("begins a leaf: {}", scene::describe_stroke(edit.stroke));
    return fmt::format("adds a line to leaf {}: {}", scene::name_of(edit.plant),
                       scene::describe_stroke(edit.stroke));
}

void list(scene::Fields& fields, EraseLeafLine& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
}

Result<scene::DocumentState> applied(scene::DocumentState state, EraseLeafLine const& edit,
                                     scene::SceneBuilder&)
{
    auto sketch = TRY(find_leaf(state, edit.plant));
    sketch = TRY(without_line(std::move(sketch), edit.line));
    return with_leaf(std::move(state), edit.plant, std::move(sketch));
}

std::string described(EraseLeafLine const& edit)
{
    return fmt::format("takes line {} of leaf {} away", scene::name_of(edit.line),
                       scene::name_of(edit.plant));
}

void list(scene::Fields& fields, FormLeaf& edit)
{
    fields.field("plant", &edit.plant);
    list(fields, edit.form);
}

Result<scene::DocumentState> applied(scene::DocumentState state, FormLeaf const& edit,
                                     scene::SceneBuilder&)
{
    auto sketch = TRY(find_leaf(state, edit.plant));
    sketch.form = edit.form;
    return with_leaf(std::move(state), edit.plant, std::move(sketch));
}

std::string described(FormLeaf const& edit)
{
    return fmt::format("gives leaf {} other numbers: bend {:g} and rise {:g} degrees, {}",
                       scene::name_of(edit.plant), edit.form.bend_deg, edit.form.rise_deg,
                       edit.form.teeth > 0 ? fmt::format("{} teeth", edit.form.teeth)
                                           : "its margin as drawn");
}

} // namespace

LeafSketch const* leaf_sketch(scene::PlantState const& plant)
{
    return plant.source.get<LeafSketch>(LeafSketch::kKind);
}

LeafSketch const* active_leaf_sketch(scene::DocumentState const& state)
{
    auto const* const plant = scene::active_plant(state);
    return plant ? leaf_sketch(*plant) : nullptr;
}

std::string describe_result(LeafSketch const& sketch)
{
    if (!sketch.seen) {
        auto const seen = recognise_leaf_sketch(sketch);
        return seen ? "" : fmt::format("No leaf yet: {}", seen.error().message);
    }
    if (!sketch.seen->left_out.empty())
        return fmt::format("A line is left out: {}", sketch.seen->left_out);
    auto const& fit = sketch.seen->fit;
    auto const lengths = fit.leaf.is_compound()
        ? fmt::format("A compound leaf, leaflets up to {:.0f} mm long,", fit.leaf.size_mm)
        : fmt::format("A leaf of {:.0f} mm", fit.leaf.size_mm);
    if (sketch.seen->is_midrib_guessed)
        return lengths + ": draw its midrib, from the stalk to the tip, and its veins";
    constexpr double kFaithful = 0.95;
    auto const overlap = overlap_with_drawing(sketch.seen->lines, fit);
    if (overlap && *overlap < kFaithful)
        return fmt::format("{} whose outline overlaps the drawn one by {:.0f} %: deep lobes and "
                           "leaflets of different shapes are not kept",
                           lengths, 100 * *overlap);
    if (fit.leaf.is_compound())
        return fmt::format("{} with {}", lengths,
                           scene::counted(sketch.seen->lines.leaflets.size(), "leaflet"));
    auto const main = fit.leaf.mains.size() - 1;
    auto const side = static_cast<std::size_t>(std::ranges::count_if(
        fit.veins, [](LeafFit::Vein const& vein) { return vein.parent != vein.stroke; }));
    return fmt::format("{} with {}{}", lengths,
                       main > 0 ? scene::counted(main, "main vein") + " beside the midrib and "
                                : "",
                       scene::counted(side, "side vein"));
}

constexpr scene::EditKind AddLeafLine::kKind
    = scene::make_edit_kind<AddLeafLine, list, applied, described>("add_leaf_line", true);

constexpr scene::EditKind EraseLeafLine::kKind
    = scene::make_edit_kind<EraseLeafLine, list, applied, described>("erase_leaf_line");

constexpr scene::EditKind FormLeaf::kKind
    = scene::make_edit_kind<FormLeaf, list, applied, described>("form_leaf");

} // namespace tractus::leaf
