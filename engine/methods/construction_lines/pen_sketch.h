#pragma once

#include "engine/methods/construction_lines/composed_model.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/pattern.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "engine/methods/construction_lines/recognise_stems.h"
#include "engine/methods/construction_lines/sketch_line.h"
#include "engine/methods/construction_lines/sketch_organ.h"
#include "engine/scene/anchored.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <vector>

namespace tractus::lines {

// A plant drawn with construction lines: the source of its base plant. It gives a plant at every
// stage of drawing. A stem alone is bare, since the reach of organs is unknown. A single boundary
// applies to both sides of the stem, and a single inclination line to the whole stem; without any
// inclination line, organs lean by 45 degrees. Lines with an unknown role have no effect.
//
// A sketch may have several stems, each with lines of its own. A stem without a boundary has the
// same organs as another stem (several_stems.h).
struct PenSketch {
    // Lines in drawing order, at least the stem. A redrawn line replaces the earlier one.
    std::vector<SketchLine> lines;
    Pattern pattern {};
    // World millimetres per plant millimetre, for lines whose SheetPlacement::size is 1.
    double scale = 0.1;
    // The organs that layers may use, in the order in which they were added.
    std::vector<SketchOrgan> organs {};
    scene::ItemId organ = 0; // Id of the organ of the whole plant; 0: plain leaves.
    // Rules of the user that replace those of the pattern; the numbers in them still come from the
    // sketch (own_rules.h).
    std::optional<scene::SourceRules> rules {};
};

extern scene::SourceKind const kPenSketch;

// Returns the sketch with one more line. The line's role is found from its position relative to the
// other lines (LineRecogniser) or, for Reading::Together, by interpreting all lines together
// (explain_sketch.h). A line that redraws another one replaces it and takes over its number of
// nodes. The line counts as drawn in space if its depth comes from the height (DepthBy::Height) and
// the surface moved, while the line was drawn, by more than a twentieth of the length of the newest
// stem.
//
// Fails with a user error if the line is a dot, the stem is too short, there are too many lines, or
// the sketch would give no plant (measure_sketch()).
Result<PenSketch> with_line(PenSketch sketch, SketchLine line);

// Returns the sketch with an additional stem, which is attached to the stem on which it begins, or
// separate if it begins on none.
Result<PenSketch> with_stem(PenSketch sketch, SketchLine line);

// Returns the sketch with a user-assigned role for a line. If the role is Stem, Left or Right, the
// line of the same stem that had this role becomes Unsure. Fails with a user error if there is no
// such line, no stem would be left, or the sketch would give no plant.
Result<PenSketch> with_role(PenSketch sketch, scene::ItemId line, Role role);

// Returns the sketch with a new stroke for one of its lines, drawn on the same sheet. Fails with a
// user error if there is no such line, or the sketch would give no plant.
Result<PenSketch> with_other_stroke(PenSketch sketch, scene::ItemId line, Stroke stroke);

// Returns the sketch with a line reversed. Reversing a stem exchanges foot and top, and left and
// right. Fails like with_role().
Result<PenSketch> with_line_turned(PenSketch sketch, scene::ItemId line);

// Returns the lines that have an effect, by stem, for measure_stems() with Missing::Guessed. With
// Unit::Sheet they are in millimetres of the sheet; with Unit::Plant they are scaled so that the
// plant appears in the document at the size at which it was drawn.
enum class Unit { Sheet, Plant };
Result<std::vector<StemLines>> stem_sketches(PenSketch const& sketch, Unit unit = Unit::Sheet);

// Returns the number of the current stem, whose lines are edited next: the stem of the newest line.
// If that stem takes its organs from another stem (function_sources()), the latter is the current
// one.
Result<std::size_t> current_stem(PenSketch const& sketch);

// Returns a sketch of only one of the stems, with its lines.
PenSketch sketch_of_stem(PenSketch const& sketch, std::size_t stem);

// Returns the line of the first stem, at whose foot the plant stands.
SketchLine const& first_stem(PenSketch const& sketch);

// Returns the lines of the current stem, for measure_sketch() with Missing::Guessed.
Result<LineSketch> line_sketch(PenSketch const& sketch);

// Returns the number of an organ in the sketch, from 1; 0 if the sketch has no such organ.
std::size_t organ_number(PenSketch const& sketch, scene::ItemId organ);

// Returns the measured sketch with its organs, in millimetres of the plant. Fails like
// measure_stems() and surface_of().
Result<ComposedSketch> composed(PenSketch const& sketch);

// Returns the sketch's plant as a model in cpfg's language, named "lines".
Result<LineModel> model_of(PenSketch const& sketch);

Result<scene::BuiltSource> build_pen_sketch(PenSketch const& sketch,
                                            scene::LoadOptions const& options);

// A layer: a part of a stem, in general between two neighbouring inclination lines, with its nodes.
struct Layer {
    // The line that stores the layer's number of nodes: the inclination line at its lower end, or
    // the stem if that line is not drawn.
    scene::ItemId line = 0;
    double from_x = 0;
    double to_x = 1;
    int nodes = 0;
};

// Returns the layers of the current stem, from below; at least one.
Result<std::vector<Layer>> layers_of(PenSketch const& sketch);

// Returns the layer beside a point on the sheet. It belongs to the nearest stem that has lines of
// its own; for a point beyond all layers it is the nearest layer.
Result<Layer> layer_at(PenSketch const& sketch, Vec2 const& place_mm);

// Returns the id of the line nearest to a point on the sheet; no value if no line is within 15 mm.
std::optional<scene::ItemId> line_at(PenSketch const& sketch, Vec2 const& place_mm);

// Finds a line by id; null if there is none.
SketchLine const* find_line(PenSketch const& sketch, scene::ItemId line);

} // namespace tractus::lines
