#include "engine/methods/construction_lines/organ_edits.h"

#include "engine/lsystem/view/view_texture.h"
#include "engine/methods/construction_lines/change_sketch.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace tractus::lines {

namespace {

constexpr std::size_t kMaxOrgans = kMaxSurfaces;

// Names of the views and colours in recorded edits, in the order of OrganView and OrganColor.
constexpr std::array kViews { "side", "midrib", "section" };
constexpr std::array kColors { "leaf",   "white", "yellow", "pink",
                               "violet", "red",   "brown",  "picture" };

Result<void> check_count(PenSketch const& sketch)
{
    if (sketch.organs.size() < kMaxOrgans)
        return {};
    return fail(Fault::User,
                fmt::format("the sketch has {} kinds of organs already: draw one of them again",
                            kMaxOrgans));
}

void list(scene::Fields& fields, DrawOrgan& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("organ", &edit.organ);
    fields.word("view", edit.view, kViews);
    fields.word("color", edit.color, kColors);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<scene::DocumentState> applied(scene::DocumentState state, DrawOrgan const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    auto const sheet = sheet_of(*state.plants[found.number], state.scale);
    SketchOrgan::Line line {
        edit.view, { .id = scene::take_id(state, edit.id), .stroke = edit.stroke, .sheet = sheet }
    };
    auto& organs = found.sketch.organs;
    if (edit.organ == 0) {
        auto const id = line.line.id;
        auto organ = TRY(with_organ_line({ .id = id, .color = edit.color }, std::move(line)));
        found.sketch = TRY(with_organ(std::move(found.sketch), std::move(organ)));
    } else {
        auto const number = organ_number(found.sketch, edit.organ);
        if (number == 0 || organs[number - 1].sketch)
            return fail(Fault::User,
                        fmt::format("the sketch has no drawn leaf {}", scene::name_of(edit.organ)));
        auto& organ = organs[number - 1];
        organ = TRY(with_organ_line(std::move(organ), std::move(line)));
        organ.color = edit.color;
    }
    TRY(model_of(found.sketch));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(DrawOrgan const& edit)
{
    auto const* const view = kViews.at(static_cast<std::size_t>(edit.view));
    if (edit.organ == 0)
        return fmt::format("draws a leaf of plant {}: {}", scene::name_of(edit.plant),
                           scene::describe_stroke(edit.stroke));
    return fmt::format("draws the {} of leaf {} of plant {}: {}", view, scene::name_of(edit.organ),
                       scene::name_of(edit.plant), scene::describe_stroke(edit.stroke));
}

void list(scene::Fields& fields, PaintOrgan& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("organ", &edit.organ);
    fields.bytes(edit.picture);
}

Result<scene::DocumentState> applied(scene::DocumentState state, PaintOrgan const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    auto& organs = found.sketch.organs;
    auto const organ = std::find_if(organs.rbegin(), organs.rend(), [&](SketchOrgan const& other) {
        return !other.sketch && (edit.organ == 0 || other.id == edit.organ);
    });
    if (organ == organs.rend())
        return fail(Fault::User,
                    fmt::format("the sketch has no drawn leaf {}", scene::name_of(edit.organ)));
    Material shown;
    if (auto const put = lsystem::put_texture(shown, edit.picture); !put)
        return fail(put.error().fault, "the leaf's picture: " + put.error().message);
    organ->picture = std::make_shared<std::string const>(edit.picture);
    organ->color = OrganColor::Picture;
    put_sketch(state, std::move(found));
    return state;
}

std::string described(PaintOrgan const& edit)
{
    auto const which = edit.organ == 0 ? "the newest leaf" : "leaf " + scene::name_of(edit.organ);
    return fmt::format("lets {} of plant {} show a picture of {}", which,
                       scene::name_of(edit.plant), scene::counted(edit.picture.size(), "byte"));
}

void list(scene::Fields& fields, SetLayerOrgan& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("line", &edit.line);
    fields.sparse_field("organ", &edit.organ);
    fields.sparse_field("of_plant", &edit.of_plant);
    fields.id(edit.id);
}

Result<SketchOrgan> find_organ(PenSketch const& sketch, scene::ItemId organ)
{
    auto const number = organ_number(sketch, organ);
    if (number == 0)
        return fail(Fault::User, fmt::format("the sketch has no organ {}", scene::name_of(organ)));
    return sketch.organs[number - 1];
}

// Adds the sketch of another plant, or one of its organs, as an organ of this sketch.
Result<scene::ItemId> taken_from(scene::DocumentState& state, PenSketch& sketch,
                                 SetLayerOrgan const& edit)
{
    if (edit.of_plant == edit.plant)
        return fail(Fault::User, "a plant cannot be an organ of itself: take another one");
    auto const other = TRY(find_sketch(state, edit.of_plant));
    TRY(check_count(sketch));
    SketchOrgan taken { .sketch = std::make_shared<PenSketch const>(other.sketch) };
    if (edit.organ != 0)
        taken = TRY(find_organ(other.sketch, edit.organ));
    taken.id = scene::take_id(state, edit.id);
    sketch.organs.push_back(taken);
    return taken.id;
}

// Removes organs that are copies of other plants and that no layer uses any more.
void drop_unborne(PenSketch& sketch)
{
    auto const is_borne = [&](scene::ItemId id) {
        return sketch.organ == id
            || std::any_of(sketch.lines.begin(), sketch.lines.end(),
                           [&](SketchLine const& line) { return line.organ == id; });
    };
    std::erase_if(sketch.organs,
                  [&](SketchOrgan const& organ) { return organ.sketch && !is_borne(organ.id); });
}

Result<scene::DocumentState> applied(scene::DocumentState state, SetLayerOrgan const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    auto& sketch = found.sketch;
    auto organ = edit.organ;
    if (edit.of_plant != 0)
        organ = TRY(taken_from(state, sketch, edit));
    else if (organ != 0)
        TRY(find_organ(sketch, organ));
    if (edit.line == 0) {
        sketch.organ = organ;
        for (auto& line : sketch.lines)
            line.organ.reset();
    } else {
        TRY(find_layer(sketch, edit.line))->organ = organ;
    }
    drop_unborne(sketch);
    TRY(model_of(sketch));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(SetLayerOrgan const& edit)
{
    auto const where = edit.line == 0
        ? std::string("all layers")
        : fmt::format("the layer above line {}", scene::name_of(edit.line));
    auto const what = edit.of_plant != 0 && edit.organ != 0
        ? fmt::format("organs {} of plant {}", scene::name_of(edit.organ),
                      scene::name_of(edit.of_plant))
        : edit.of_plant != 0 ? fmt::format("plants like {}", scene::name_of(edit.of_plant))
        : edit.organ != 0    ? fmt::format("organs {}", scene::name_of(edit.organ))
                             : std::string("plain leaves");
    return fmt::format("lets {} of plant {} bear {}", where, scene::name_of(edit.plant), what);
}

} // namespace

Result<PenSketch> with_organ(PenSketch sketch, SketchOrgan organ)
{
    TRY(check_count(sketch));
    auto const id = organ.id;
    sketch.organs.push_back(std::move(organ));
    if (sketch.organs.size() == 1)
        sketch.organ = id;
    else {
        auto const layers = TRY(layers_of(sketch));
        TRY(find_layer(sketch, layers.back().line))->organ = id;
    }
    TRY(model_of(sketch));
    return sketch;
}

constexpr scene::EditKind DrawOrgan::kKind
    = scene::make_edit_kind<DrawOrgan, list, applied, described>("draw_line_organ");

constexpr scene::EditKind PaintOrgan::kKind
    = scene::make_edit_kind<PaintOrgan, list, applied, described>("paint_line_organ");

constexpr scene::EditKind SetLayerOrgan::kKind
    = scene::make_edit_kind<SetLayerOrgan, list, applied, described>("set_layer_organ");

} // namespace tractus::lines
