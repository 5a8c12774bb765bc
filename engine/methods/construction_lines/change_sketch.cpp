#include "engine/methods/construction_lines/change_sketch.h"

#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/construction_lines/read_pen_sketch.h"
#include "engine/scene/edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

Vec2 foot_on_sheet(PenSketch const& sketch)
{
    // If the lines are interpreted together, the stem may be reversed, composed of several strokes,
    // or freed from hooks, so its foot is not where its stroke begins.
    if (is_read_together(sketch))
        if (auto const reading = read_pen_sketch(sketch); reading && !reading->stems.empty())
            if (auto const& stem = reading->stems.front().sketch.stem; !stem.empty())
                return stem.front().head<2>();
    auto const& line = first_stem(sketch);
    return line.sheet.on_sheet(begin_on_tablet(line));
}

Result<FoundSketch> find_sketch(scene::DocumentState const& state, scene::ItemId plant)
{
    auto const number = TRY(scene::plant_number(state, plant));
    auto const* const sketch = pen_sketch(*state.plants[number]);
    if (!sketch)
        return fail(Fault::User,
                    fmt::format("plant {} is not drawn with construction lines: begin another one "
                                "with a stem",
                                scene::name_of(plant)));
    return FoundSketch { number, *sketch };
}

Result<SketchLine*> find_layer(PenSketch& sketch, scene::ItemId line)
{
    auto const found = std::find_if(sketch.lines.begin(), sketch.lines.end(),
                                    [&](SketchLine const& each) { return each.id == line; });
    if (found == sketch.lines.end())
        return fail(
            Fault::User,
            fmt::format("the sketch has no line {}, so no layer above it", scene::name_of(line)));
    return &*found;
}

Vec2 begin_on_tablet(SketchLine const& line)
{
    auto const tips = line.stroke.tips.in_memory();
    return tips && !tips->empty() ? Vec2(tips->front().position_mm.head<2>()) : Vec2(0, 0);
}

void put_sketch(scene::DocumentState& state, FoundSketch found)
{
    auto const& before = *state.plants[found.number];
    auto const sheet = sheet_of(before, state.scale);
    bool const is_other = is_read_together(found.sketch)
        || first_stem(found.sketch).id != first_stem(*pen_sketch(before)).id;
    Vec2 const foot_mm = sheet.on_tablet(foot_on_sheet(found.sketch));
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

void list(scene::Fields& fields, Pattern& pattern)
{
    // Names of the patterns, in the order of Pattern::Kind.
    constexpr std::array kPatterns { "distichous", "decussate", "spiral",
                                     "alternate",  "whorled",   "bare" };
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
    constexpr int kMinWhorl = 2;
    constexpr int kMaxWhorl = 24;
    if (!(std::fabs(pattern.divergence_deg) <= 360))
        return fail(Fault::User, "the divergence is no angle: give degrees from -360 to 360");
    if (pattern.whorl < kMinWhorl || pattern.whorl > kMaxWhorl)
        return fail(Fault::User,
                    fmt::format("{} organs cannot stand around a node: give {} to {}",
                                pattern.whorl, kMinWhorl, kMaxWhorl));
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
    Vec2 const foot_mm = foot_on_sheet(sketch);
    return { foot_mm - size * plant.paper_mm.value_or(foot_mm), size };
}

} // namespace tractus::lines
