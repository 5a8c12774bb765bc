#include "engine/methods/construction_lines/line_edits.h"

#include "engine/methods/construction_lines/bend_lines.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

using scene::name_of; // Of items.

namespace {

// In the order of the enumerations' values.
constexpr std::array kPatterns {
    "distichous", "decussate", "spiral", "alternate", "whorled", "bare"
};
constexpr std::array kRoles { "stem",   "left",  "right", "inclination", "half_inclination",
                              "unsure", "around" };

void list(scene::Fields& fields, Pattern& pattern)
{
    fields.word("pattern", pattern.kind, kPatterns);
    fields.field("divergence", &pattern.divergence_deg);
    fields.field("whorl", &pattern.whorl);
    int half_ellipses = pattern.sizes == Pattern::Sizes::HalfEllipses ? 1 : 0;
    fields.sparse_field("half_ellipses", &half_ellipses);
    pattern.sizes = half_ellipses != 0 ? Pattern::Sizes::HalfEllipses : Pattern::Sizes::Linear;
    int face = static_cast<int>(pattern.face);
    fields.sparse_field("face", &face);
    pattern.face = static_cast<Pattern::Face>(std::clamp(face, 0, 3));
}

Result<void> check_pattern(Pattern const& pattern)
{
    constexpr int kLeastWhorl = 2;
    constexpr int kMostWhorl = 24;
    if (!(std::fabs(pattern.divergence_deg) <= 360))
        return fail(Fault::User, "the divergence is no angle: give degrees from -360 to 360");
    if (pattern.whorl < kLeastWhorl || pattern.whorl > kMostWhorl)
        return fail(Fault::User,
                    fmt::format("{} organs cannot stand around a node: give {} to {}",
                                pattern.whorl, kLeastWhorl, kMostWhorl));
    return {};
}

Result<void> check_nodes(int nodes)
{
    if (nodes < 0 || nodes > kMostNodesInLayer)
        return fail(
            Fault::User,
            fmt::format("a layer cannot have {} nodes: give 0 to {}", nodes, kMostNodesInLayer));
    return {};
}

std::string describe(Pattern const& pattern)
{
    auto const name
        = fmt::format("{}{}", name_of(pattern.kind),
                      pattern.sizes == Pattern::Sizes::HalfEllipses ? " by half-ellipses" : "");
    if (pattern.kind == Pattern::Kind::Whorled)
        return fmt::format("{}, {} at a node", name, pattern.whorl);
    if (pattern.kind == Pattern::Kind::Spiral || pattern.kind == Pattern::Kind::Alternate)
        return fmt::format("{}, {:g} degrees from one to the next", name, pattern.divergence_deg);
    return name;
}

// Of which plant, and its sketch.
struct Found {
    std::size_t number = 0;
    PenSketch sketch;
};

Result<Found> find_sketch(scene::DocumentState const& state, scene::ItemId plant)
{
    auto const number = TRY(scene::plant_number(state, plant));
    auto const* const sketch = pen_sketch(*state.plants[number]);
    if (!sketch)
        return fail(Fault::User,
                    fmt::format("plant {} is not drawn with construction lines: begin another one "
                                "with a stem",
                                scene::name_of(plant)));
    return Found { number, *sketch };
}

// Where the pen came down for a line, on the tablet then, and on the sheet.
Vec2 begin_on_tablet(SketchLine const& line)
{
    auto const tips = line.stroke.tips.in_memory();
    return tips && !tips->empty() ? Vec2(tips->front().position_mm.head<2>()) : Vec2(0, 0);
}

Vec2 begin_on_sheet(SketchLine const& line)
{
    return line.sheet.on_sheet(begin_on_tablet(line));
}

// Puts another sketch in the place of a plant's. Where it has another stem the plant stands at that
// one's foot, and so all of its lines stay where they are.
void put_sketch(scene::DocumentState& state, Found found)
{
    auto const& before = *state.plants[found.number];
    auto const sheet = sheet_of(before, state.scale);
    auto const& stem = first_stem(found.sketch);
    bool const is_other = stem.id != first_stem(*pen_sketch(before)).id;
    Vec2 const foot_mm = sheet.on_tablet(begin_on_sheet(stem));
    scene::change_plant(state, found.number, [&](scene::PlantState& plant) {
        if (is_other && plant.paper_mm) {
            plant.stands_at_mm.x() += foot_mm.x() - plant.paper_mm->x();
            plant.paper_mm = foot_mm;
        }
        plant.source = scene::PlantSource(kPenSketch, std::move(found.sketch));
        plant.source_edit = state.last_edit;
        plant.selection.clear();
    });
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
                            .depth_by = edit.depth_by };
    auto sketch
        = TRY(with_line({ .lines = {}, .pattern = edit.pattern, .scale = edit.scale }, stem));
    if (!state.scale)
        state.scale = edit.scale;
    return scene::with_source(std::move(state),
                              { .name = "lines",
                                .source = scene::PlantSource(kPenSketch, std::move(sketch)),
                                .drawn = scene::Drawn::Beside,
                                .stands_at_mm = edit.stands_at_mm,
                                .paper_mm = begin_on_tablet(stem),
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
                             .depth_by = edit.depth_by }));
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
    auto& lines = found.sketch.lines;
    auto const line = std::find_if(lines.begin(), lines.end(),
                                   [&](SketchLine const& each) { return each.id == edit.line; });
    if (line == lines.end())
        return fail(Fault::User,
                    fmt::format("the sketch has no line {}, so no layer above it",
                                scene::name_of(edit.line)));
    line->nodes = edit.nodes;
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
    list(fields, edit.pattern);
}

Result<scene::DocumentState> applied(scene::DocumentState state, SetLinePattern const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_pattern(edit.pattern));
    auto found = TRY(find_sketch(state, edit.plant));
    found.sketch.pattern = edit.pattern;
    put_sketch(state, std::move(found));
    return state;
}

std::string described(SetLinePattern const& edit)
{
    return fmt::format("gives the organs of plant {} another pattern: {}",
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

PenSketch const* pen_sketch(scene::PlantState const& plant)
{
    return plant.source.get<PenSketch>(kPenSketch);
}

PenSketch const* active_pen_sketch(scene::DocumentState const& state)
{
    auto const* const plant = scene::active_plant(state);
    return plant ? pen_sketch(*plant) : nullptr;
}

SheetPlacement sheet_of(scene::PlantState const& plant, std::optional<double> scale)
{
    auto const& sketch = *pen_sketch(plant);
    double const size = sketch.scale / scale.value_or(sketch.scale);
    Vec2 const foot_mm = begin_on_sheet(first_stem(sketch));
    return { foot_mm - size * plant.paper_mm.value_or(foot_mm), size };
}

constexpr scene::EditKind AddLine::kKind
    = scene::make_edit_kind<AddLine, list, applied, described>("add_construction_line", true);

constexpr scene::EditKind SetLayerNodes::kKind
    = scene::make_edit_kind<SetLayerNodes, list, applied, described>("set_layer_nodes");

constexpr scene::EditKind SetLinePattern::kKind
    = scene::make_edit_kind<SetLinePattern, list, applied, described>("set_line_pattern");

constexpr scene::EditKind RedrawLine::kKind
    = scene::make_edit_kind<RedrawLine, list, applied, described>("redraw_construction_line");

constexpr scene::EditKind BendStem::kKind
    = scene::make_edit_kind<BendStem, list, applied, described>("bend_stem");

constexpr scene::EditKind SetLineRole::kKind
    = scene::make_edit_kind<SetLineRole, list, applied, described>("set_line_role");

} // namespace tractus::lines
