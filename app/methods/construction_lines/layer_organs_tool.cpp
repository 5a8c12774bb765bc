#include "app/methods/construction_lines/layer_organs_tool.h"

#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/line_pattern_tool.h"
#include "app/methods/construction_lines/touched_sketch.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "engine/scene/paper.h"

#include <array>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 4> kLayerWords { {
    { "layer_organ", "Layer's organ" },
    { "layer_pattern", "Layer's pattern" },
    { "layer_face", "Turn a layer" },
    { "layer_plant", "Bring an organ" },
} };

void visit(tools::OptionVisitor& visitor, LayerOrgansTool& tool)
{
    visitor.choice({ kLayerWords, tools::WordOption::Offered::InHand }, tool.what);
}

// A layer of a sketch that was touched: the inclination line that bounds it, and its organs.
struct TouchedLayer {
    // Inclination line that bounds the layer. 0: no line does, because the stem still has a single
    // layer.
    scene::ItemId line = 0;
    lines::Pattern pattern {};
    scene::ItemId organ = 0;
};

Result<TouchedLayer> touched_layer(ActiveSketch const& active, Stroke const& stroke)
{
    auto const& sketch = active.sketch;
    auto const layer = TRY(lines::layer_at(sketch, touched_mm(active, stroke)));
    auto const& line = *lines::find_line(sketch, layer.line);
    bool const is_all = line.role == lines::Role::Stem;
    return TouchedLayer { is_all ? 0 : layer.line, line.pattern.value_or(sketch.pattern),
                          line.organ.value_or(sketch.organ) };
}

// The kind of organ that follows `organ` in the sketch; plain leaves follow the last kind and
// precede the first.
Result<scene::ItemId> next_organ(lines::PenSketch const& sketch, scene::ItemId organ)
{
    if (sketch.organs.empty())
        return fail(Fault::User,
                    "the plant has nothing but plain leaves: draw a leaf's edge, or bring an "
                    "organ here");
    auto const next = lines::organ_number(sketch, organ);
    return next < sketch.organs.size() ? sketch.organs[next].id : 0;
}

// The leaf of the sketch that has a line at this place on the sheet; 0 if there is none.
scene::ItemId leaf_at(lines::PenSketch const& sketch, Vec2 const& place_mm)
{
    for (auto const& organ : sketch.organs) {
        lines::PenSketch of_lines;
        for (auto const& line : organ.lines)
            of_lines.lines.push_back(line.line);
        if (lines::line_at(of_lines, place_mm))
            return organ.id;
    }
    return 0;
}

// What a stroke begins on and is to become an organ: a drawn leaf, or a plant that is touched at
// one of its construction lines.
struct Dragged {
    scene::ItemId plant = 0;
    scene::ItemId organ = 0;
};

Result<Dragged> dragged(Stroke const& stroke, scene::Scene const& scene)
{
    auto const world_mm
        = scene::paper_of(scene.state).world_of_sheet(stroke.tips.front().position_mm.head<2>());
    for (auto const& plant : scene.state.plants) {
        auto const* const sketch = lines::pen_sketch(*plant);
        auto const paper = scene::paper_of(*plant);
        if (!sketch || !paper || plant->is_hidden)
            continue;
        auto const place_mm
            = lines::sheet_of(*plant, scene.state.scale).on_sheet(paper->sheet_of_world(world_mm));
        if (auto const organ = leaf_at(*sketch, place_mm))
            return Dragged { plant->id, organ };
        if (plant->id != scene.state.active && lines::line_at(*sketch, place_mm))
            return Dragged { plant->id };
    }
    return fail(Fault::User,
                "neither a leaf nor another plant with construction lines is here: begin the "
                "stroke on a line of what is to be an organ, and end it beside the layer that is "
                "to bear it");
}

Result<scene::Edit> bring(ActiveSketch const& active, TouchedLayer const& layer,
                          Stroke const& stroke, scene::Scene const& scene)
{
    auto const what = TRY(dragged(stroke, scene));
    return lines::SetLayerOrgan { .plant = active.plant,
                                  .line = layer.line,
                                  .organ = what.organ,
                                  .of_plant = what.plant == active.plant ? 0 : what.plant };
}

Result<std::vector<scene::Edit>> change_layer(tools::Tool const& tool, Stroke const& stroke,
                                              scene::Scene const& scene)
{
    auto const active = TRY(active_sketch(scene));
    auto const layer = TRY(touched_layer(active, stroke));
    using Edits = std::vector<scene::Edit>;
    using Change = LayerOrgansTool::What;
    switch (tool.get<LayerOrgansTool>()->what) {
    case Change::Pattern:
        return Edits { lines::SetLinePattern { active.plant, next_pattern(layer.pattern),
                                               layer.line } };
    case Change::Face:
        return Edits { lines::SetLinePattern { active.plant, next_face(layer.pattern),
                                               layer.line } };
    case Change::Organ:
        return Edits { lines::SetLayerOrgan { active.plant, layer.line,
                                              TRY(next_organ(active.sketch, layer.organ)) } };
    case Change::Plant:
        break;
    }
    return Edits { TRY(bring(active, layer, stroke, scene)) };
}

} // namespace

constexpr tools::ToolKind LayerOrgansTool::kKind {
    .word = "layer_organs",
    .label = "Layer's organ",
    .title = "Change what a layer bears",
    .done = "The layer bears something else now",
    .help = "gives the layer of a sketch beside which the stroke ends the next of the organs that "
            "were drawn, or plain leaves, or the next pattern; turns its organs; or gives it the "
            "leaf, or plants like the one, on whose lines the stroke begins",
    .group = "Sketch",
    .method = "From lines",
    .begins_group_of_buttons = true,
    .surface = tools::Surface::Paper,
    .options = tools::options_type<LayerOrgansTool, visit>(),
    .edits_for = change_layer,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
