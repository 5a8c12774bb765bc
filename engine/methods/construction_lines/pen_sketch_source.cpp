#include "engine/methods/construction_lines/composed_model.h"
#include "engine/methods/construction_lines/own_rules.h"
#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/methods/construction_lines/varied_sketch.h"
#include "engine/scene/lsystem_source.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace tractus::lines {

namespace {

bool same(SketchLine const& one, SketchLine const& other)
{
    return one.id == other.id && one.stroke.tips.id() == other.stroke.tips.id()
        && one.sheet.offset_mm == other.sheet.offset_mm && one.sheet.size == other.sheet.size
        && one.role == other.role && one.nodes == other.nodes && one.stem == other.stem
        && one.parent == other.parent && one.depth_by == other.depth_by
        && one.level_mm == other.level_mm && one.pattern == other.pattern
        && one.organ == other.organ && one.reading == other.reading
        && one.is_assigned == other.is_assigned && one.turn_round == other.turn_round;
}

bool same(SketchOrgan const& one, SketchOrgan const& other)
{
    return one.id == other.id && one.color == other.color && one.picture == other.picture
        && one.sketch == other.sketch
        && std::equal(one.lines.begin(), one.lines.end(), other.lines.begin(), other.lines.end(),
                      [](SketchOrgan::Line const& line, SketchOrgan::Line const& another) {
                          return line.view == another.view && same(line.line, another.line);
                      });
}

bool same(PenSketch const& one, PenSketch const& other)
{
    return one.pattern == other.pattern && one.scale == other.scale && one.organ == other.organ
        && one.rules == other.rules
        && std::equal(one.organs.begin(), one.organs.end(), other.organs.begin(),
                      other.organs.end(),
                      [](SketchOrgan const& organ, SketchOrgan const& another) {
                          return same(organ, another);
                      })
        && std::equal(one.lines.begin(), one.lines.end(), other.lines.begin(), other.lines.end(),
                      [](SketchLine const& line, SketchLine const& another) {
                          return same(line, another);
                      });
}

// Returns the pattern of a sketch: Bare if none of its stems has a boundary.
Pattern pattern_of(PenSketch const& sketch, std::vector<StemLines> const& stems)
{
    auto pattern = sketch.pattern;
    if (!has_boundary(stems))
        pattern.kind = Pattern::Kind::Bare;
    return pattern;
}

} // namespace

constexpr scene::SourceKind kPenSketch {
    .word = "construction_lines",
    .build =
        [](void const* drawn, scene::LoadOptions const& options) {
            return build_pen_sketch(*static_cast<PenSketch const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<PenSketch const*>(one), *static_cast<PenSketch const*>(other));
        },
    .model = [](void const* drawn) -> Result<scene::SourceModel> {
        auto model = TRY(model_of(*static_cast<PenSketch const*>(drawn)));
        return scene::SourceModel { std::move(model.source), std::move(model.functions) };
    },
    .vary = [](void const* drawn,
               scene::SourceVariation const& variation) -> std::shared_ptr<void const> {
        return std::make_shared<PenSketch const>(
            varied_sketch(*static_cast<PenSketch const*>(drawn), variation));
    },
    .with_rules
    = [](void const* drawn,
         std::optional<scene::SourceRules> const& rules) -> std::shared_ptr<void const> {
        auto sketch = *static_cast<PenSketch const*>(drawn);
        sketch.rules = rules;
        return std::make_shared<PenSketch const>(std::move(sketch));
    },
};

Result<ComposedSketch> composed(PenSketch const& sketch)
{
    auto const lines = TRY(stem_sketches(sketch, Unit::Plant));
    ComposedSketch result { .stems = TRY(measure_stems(lines, Missing::Guessed)),
                            .pattern = pattern_of(sketch, lines) };
    for (auto const& organ : sketch.organs) {
        LineOrgan built;
        if (organ.sketch)
            built.sketch = std::make_shared<ComposedSketch const>(TRY(composed(*organ.sketch)));
        else
            built.surface = TRY(surface_of(organ));
        result.organs.push_back(std::move(built));
    }
    return result;
}

Result<LineModel> model_of(PenSketch const& sketch)
{
    auto const measured = TRY(composed(sketch));
    auto model = write_composed_model(measured, "lines");
    return model && sketch.rules ? with_own_rules(*std::move(model), *sketch.rules) : model;
}

Result<scene::BuiltSource> build_pen_sketch(PenSketch const& sketch,
                                            scene::LoadOptions const& options)
{
    auto model = TRY(model_of(sketch));
    return scene::build_lsystem(
        { .source = std::move(model.source), .includes = std::move(model.functions) }, options);
}

} // namespace tractus::lines
