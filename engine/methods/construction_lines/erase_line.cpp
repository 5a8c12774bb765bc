#include "engine/methods/construction_lines/erase_line.h"

#include "engine/methods/construction_lines/change_sketch.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/construction_lines/read_pen_sketch.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

using Numbers = std::vector<std::size_t>;

bool is_among(Numbers const& numbers, std::size_t number)
{
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

// Numbers of a stem and of all stems attached to it, directly or through other stems.
Numbers standing_on(PenSketch const& sketch, std::size_t stem)
{
    Numbers stems { stem };
    for (std::size_t i = 0; i < stems.size(); ++i)
        for (auto const& line : sketch.lines)
            if (line.role == Role::Stem && line.parent == stems[i] && !is_among(stems, line.stem))
                stems.push_back(line.stem);
    return stems;
}

Result<PenSketch> without_stem(PenSketch sketch, std::size_t stem)
{
    auto const gone = standing_on(sketch, stem);
    auto const number_now = [&](std::size_t number) {
        return number
            - static_cast<std::size_t>(std::count_if(
                gone.begin(), gone.end(), [&](std::size_t before) { return before < number; }));
    };
    std::erase_if(sketch.lines, [&](SketchLine const& line) { return is_among(gone, line.stem); });
    if (sketch.lines.empty())
        return fail(Fault::User,
                    "the plant would have no stem: draw it again, or take the plant away with "
                    "Remove, under "
                    "Plants");
    for (auto& line : sketch.lines) {
        line.stem = number_now(line.stem);
        if (line.parent)
            line.parent = number_now(*line.parent);
    }
    return sketch;
}

void drop_organ(PenSketch& sketch, scene::ItemId organ)
{
    std::erase_if(sketch.organs, [&](SketchOrgan const& each) { return each.id == organ; });
    if (sketch.organ == organ)
        sketch.organ = 0;
    for (auto& line : sketch.lines)
        if (line.organ == organ)
            line.organ = 0;
}

// Removes a line of a leaf, and the leaf itself if none of its sides is left.
Result<PenSketch> without_organ_line(PenSketch sketch, SketchOrgan organ, scene::ItemId line)
{
    std::erase_if(organ.lines, [&](SketchOrgan::Line const& each) { return each.line.id == line; });
    bool const has_side
        = std::any_of(organ.lines.begin(), organ.lines.end(),
                      [](SketchOrgan::Line const& each) { return each.view == OrganView::Side; });
    if (!has_side) {
        drop_organ(sketch, organ.id);
        return sketch;
    }
    TRY(surface_of(organ));
    for (auto& each : sketch.organs)
        if (each.id == organ.id)
            each = organ;
    return sketch;
}

// True if the line is one of several strokes that form a stem together.
bool is_piece_of_stem(PenSketch const& sketch, SketchLine const& line)
{
    auto const count
        = std::count_if(sketch.lines.begin(), sketch.lines.end(), [&](SketchLine const& each) {
              return each.role == Role::Stem && each.stem == line.stem;
          });
    return is_read_together(sketch) && count > 1;
}

void list(scene::Fields& fields, EraseLine& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("line", &edit.line);
}

Result<scene::DocumentState> applied(scene::DocumentState state, EraseLine const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    found.sketch = TRY(without_line(std::move(found.sketch), edit.line));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(EraseLine const& edit)
{
    return fmt::format("erases line {} of plant {}", scene::name_of(edit.line),
                       scene::name_of(edit.plant));
}

} // namespace

Result<PenSketch> without_line(PenSketch sketch, scene::ItemId line)
{
    auto const organ
        = std::find_if(sketch.organs.begin(), sketch.organs.end(), [&](SketchOrgan const& each) {
              return std::any_of(
                  each.lines.begin(), each.lines.end(),
                  [&](SketchOrgan::Line const& drawn) { return drawn.line.id == line; });
          });
    auto const* const found = find_line(sketch, line);
    if (organ != sketch.organs.end()) {
        sketch = TRY(without_organ_line(sketch, *organ, line));
    } else if (!found) {
        return fail(Fault::User,
                    fmt::format("the sketch has no line {} any more", scene::name_of(line)));
    } else if (found->role == Role::Stem && !is_piece_of_stem(sketch, *found)) {
        sketch = TRY(without_stem(sketch, found->stem));
    } else {
        std::erase_if(sketch.lines, [&](SketchLine const& each) { return each.id == line; });
    }
    sketch = TRY(with_roles_read(std::move(sketch)));
    TRY(model_of(sketch));
    return sketch;
}

constexpr scene::EditKind EraseLine::kKind
    = scene::make_edit_kind<EraseLine, list, applied, described>("erase_construction_line");

} // namespace tractus::lines
