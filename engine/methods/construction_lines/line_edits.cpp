#include "engine/methods/construction_lines/line_edits.h"

#include "engine/methods/construction_lines/bend_lines.h"
#include "engine/methods/construction_lines/change_sketch.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

using scene::name_of; // Gives the name of an item, for messages.

namespace {

// Names of the roles in recorded edits, in the order of Role.
constexpr std::array kRoles {
    "stem", "left", "right", "inclination", "half_inclination", "unsure", "around", "closed_outline"
};

Result<void> check_nodes(int nodes)
{
    if (nodes < 0 || nodes > kMaxNodesInLayer)
        return fail(
            Fault::User,
            fmt::format("a layer cannot have {} nodes: give 0 to {}", nodes, kMaxNodesInLayer));
    return {};
}

void list(scene::Fields& fields, AddLine& edit)
{
    fields.sparse_field("plant", &edit.plant);
    int another_stem = edit.another_stem ? 1 : 0;
    fields.sparse_field("another_stem", &another_stem);
    edit.another_stem = another_stem != 0;
    int depth_by = static_cast<int>(edit.depth_by);
    fields.sparse_field("depth_by", &depth_by);
    edit.depth_by = static_cast<DepthBy>(std::clamp(depth_by, 0, 2));
    int together = edit.reading == Reading::Together ? 1 : 0;
    fields.sparse_field("together", &together);
    edit.reading = together != 0 ? Reading::Together : Reading::OneByOne;
    fields.field("nodes", &edit.nodes);
    list(fields, edit.pattern);
    fields.field("scale", &edit.scale);
    fields.field("stands_at_mm", &edit.stands_at_mm);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<scene::DocumentState> begun(scene::DocumentState state, AddLine const& edit)
{
    TRY(check_pattern(edit.pattern));
    if (!(edit.scale > 0 && std::isfinite(edit.scale)))
        return fail(Fault::User,
                    fmt::format("a plant cannot be shown {} times as large as it is", edit.scale));
    if (!edit.stands_at_mm.allFinite())
        return fail(Fault::User, "the place for the plant is not a number: draw the stem again");
    SketchLine const stem { .id = scene::take_id(state, edit.id),
                            .stroke = edit.stroke,
                            .nodes = edit.nodes,
                            .depth_by = edit.depth_by,
                            .reading = edit.reading };
    auto sketch
        = TRY(with_line({ .lines = {}, .pattern = edit.pattern, .scale = edit.scale }, stem));
    if (!state.scale)
        state.scale = edit.scale;
    // The sheet of a new plant has the tablet's scale, so distances on sheet and tablet are equal.
    Vec2 const foot_mm = foot_on_sheet(sketch);
    Vec3 const aside_mm(foot_mm.x() - begin_on_tablet(stem).x(), 0, 0);
    return scene::with_source(std::move(state),
                              { .name = "lines",
                                .source = scene::PlantSource(kPenSketch, std::move(sketch)),
                                .drawn = scene::Drawn::Beside,
                                .stands_at_mm = edit.stands_at_mm + aside_mm,
                                .paper_mm = foot_mm,
                                .id = stem.id });
}

Result<scene::DocumentState> applied(scene::DocumentState state, AddLine const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_nodes(edit.nodes));
    if (edit.plant == 0)
        return begun(std::move(state), edit);
    auto found = TRY(find_sketch(state, edit.plant));
    auto const sheet = sheet_of(*state.plants[found.number], state.scale);
    auto const add = edit.another_stem ? with_stem : with_line;
    found.sketch = TRY(add(std::move(found.sketch),
                           { .id = scene::take_id(state, edit.id),
                             .stroke = edit.stroke,
                             .sheet = sheet,
                             .nodes = edit.nodes,
                             .depth_by = edit.depth_by,
                             .reading = edit.reading }));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(AddLine const& edit)
{
    if (edit.plant == 0)
        return fmt::format("begins a plant of construction lines, {}: {}", describe(edit.pattern),
                           scene::describe_stroke(edit.stroke));
    return fmt::format("adds {} to plant {}: {}",
                       edit.another_stem ? "another stem" : "a construction line",
                       scene::name_of(edit.plant), scene::describe_stroke(edit.stroke));
}

void list(scene::Fields& fields, SetLayerNodes& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
    fields.field("nodes", &edit.nodes);
}

Result<scene::DocumentState> applied(scene::DocumentState state, SetLayerNodes const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_nodes(edit.nodes));
    auto found = TRY(find_sketch(state, edit.plant));
    TRY(find_layer(found.sketch, edit.line))->nodes = edit.nodes;
    put_sketch(state, std::move(found));
    return state;
}

std::string described(SetLayerNodes const& edit)
{
    return fmt::format("gives the layer above line {} of plant {} {}", scene::name_of(edit.line),
                       scene::name_of(edit.plant),
                       scene::counted(static_cast<std::size_t>(std::max(0, edit.nodes)), "node"));
}

void list(scene::Fields& fields, SetLinePattern& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("line", &edit.line);
    list(fields, edit.pattern);
}

Result<scene::DocumentState> applied(scene::DocumentState state, SetLinePattern const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_pattern(edit.pattern));
    auto found = TRY(find_sketch(state, edit.plant));
    if (edit.line != 0) {
        TRY(find_layer(found.sketch, edit.line))->pattern = edit.pattern;
    } else {
        if (edit.pattern.kind != found.sketch.pattern.kind)
            found.sketch.rules.reset();
        found.sketch.pattern = edit.pattern;
        for (auto& line : found.sketch.lines)
            line.pattern.reset();
    }
    put_sketch(state, std::move(found));
    return state;
}

std::string described(SetLinePattern const& edit)
{
    auto const of_layer = edit.line == 0
        ? std::string()
        : fmt::format("of the layer above line {} ", scene::name_of(edit.line));
    return fmt::format("gives the organs {}of plant {} another pattern: {}", of_layer,
                       scene::name_of(edit.plant), describe(edit.pattern));
}

void list(scene::Fields& fields, SetLineRole& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
    fields.word("role", edit.role, kRoles);
}

Result<scene::DocumentState> applied(scene::DocumentState state, SetLineRole const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    found.sketch = TRY(with_role(std::move(found.sketch), edit.line, edit.role));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(SetLineRole const& edit)
{
    return fmt::format("takes line {} of plant {} for: {}", scene::name_of(edit.line),
                       scene::name_of(edit.plant), name_of(edit.role));
}

void list(scene::Fields& fields, RedrawLine& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
    fields.numbers(edit.stroke);
}

Result<scene::DocumentState> applied(scene::DocumentState state, RedrawLine const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    found.sketch = TRY(with_other_stroke(std::move(found.sketch), edit.line, edit.stroke));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(RedrawLine const& edit)
{
    return fmt::format("draws line {} of plant {} otherwise: {}", scene::name_of(edit.line),
                       scene::name_of(edit.plant), scene::describe_stroke(edit.stroke));
}

void list(scene::Fields& fields, TurnLine& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
}

Result<scene::DocumentState> applied(scene::DocumentState state, TurnLine const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    found.sketch = TRY(with_line_turned(std::move(found.sketch), edit.line));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(TurnLine const& edit)
{
    return fmt::format("turns line {} of plant {} round", scene::name_of(edit.line),
                       scene::name_of(edit.plant));
}

void list(scene::Fields& fields, BendStem& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
    fields.field("place", &edit.place);
    fields.field("heading", &edit.heading_deg);
}

Result<scene::DocumentState> applied(scene::DocumentState state, BendStem const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    found.sketch
        = TRY(with_heading(std::move(found.sketch), edit.line,
                           static_cast<std::size_t>(std::max(0, edit.place)), edit.heading_deg));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(BendStem const& edit)
{
    return fmt::format("bends stem {} of plant {} to {:g} degrees at place {} of {}",
                       scene::name_of(edit.line), scene::name_of(edit.plant), edit.heading_deg,
                       edit.place + 1, kHeadingPlaces.size());
}

} // namespace

constexpr scene::EditKind AddLine::kKind
    = scene::make_edit_kind<AddLine, list, applied, described>("add_construction_line", true);

constexpr scene::EditKind SetLayerNodes::kKind
    = scene::make_edit_kind<SetLayerNodes, list, applied, described>("set_layer_nodes");

constexpr scene::EditKind SetLinePattern::kKind
    = scene::make_edit_kind<SetLinePattern, list, applied, described>("set_line_pattern");

constexpr scene::EditKind RedrawLine::kKind
    = scene::make_edit_kind<RedrawLine, list, applied, described>("redraw_construction_line");

constexpr scene::EditKind TurnLine::kKind
    = scene::make_edit_kind<TurnLine, list, applied, described>("turn_construction_line");

constexpr scene::EditKind BendStem::kKind
    = scene::make_edit_kind<BendStem, list, applied, described>("bend_stem");

constexpr scene::EditKind SetLineRole::kKind
    = scene::make_edit_kind<SetLineRole, list, applied, described>("set_line_role");

} // namespace tractus::lines
