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
// stage of drawing: the stem alone is bare, since the reach of organs is unknown; a single boundary
// applies to both sides, and a single inclination line to the whole stem; without any, organs lean
// by 45 degrees. Lines with an unknown role have no effect.
//
// A sketch may have several stems, each with lines of its own; a stem without a boundary has the
// organs of another (several_stems.h). Functions below that concern one stem say so.
struct PenSketch {
    // Lines in drawing order, at least the stem; a redrawn line takes the place of the earlier one.
    std::vector<SketchLine> lines;
    Pattern pattern {};
    // World millimetres per plant millimetre, for lines with SheetPlacement::size 1.
    double scale = 0.1;
    // The organs that layers may use, in the order in which they were added.
    std::vector<SketchOrgan> organs {};
    scene::ItemId organ = 0; // The organ of the whole plant; 0: plain leaves.
    // Rules that replace those of the pattern; their numbers still come from the sketch
    // (own_rules.h).
    std::optional<scene::SourceRules> rules {};
};

extern scene::SourceKind const kPenSketch;

// Returns the sketch with one more line. Its role is found from its position relative to the other
// lines (LineRecogniser), or, for Reading::Together, together with theirs (explain_sketch.h). If it
// redraws a line it replaces that line and takes over its number of nodes. The line is in space if
// its depth is to be used and the surface has moved while drawing by more than a twentieth of the
// length of the stem drawn last.
//
// Fails with a user error if the line is a dot, the stem is too short, there are too many lines, or
// the sketch would give no plant (measure_sketch()).
Result<PenSketch> with_line(PenSketch sketch, SketchLine line);

// Returns the sketch with another stem: attached to the stem on which it begins, or separate.
Result<PenSketch> with_stem(PenSketch sketch, SketchLine line);

// Returns the sketch with a user-assigned role for a line. If the role is Stem, Left or Right, the
// line of the same stem that had it becomes Unsure. Fails with a user error if there is no such
// line, no stem would be left, or the sketch would give no plant.
Result<PenSketch> with_role(PenSketch sketch, scene::ItemId line, Role role);

// Returns the sketch with another stroke for a line, drawn on the same sheet. Fails with a user
// error if there is no such line, or the sketch would give no plant.
Result<PenSketch> with_other_stroke(PenSketch sketch, scene::ItemId line, Stroke stroke);

// Returns the sketch with a line reversed. Reversing a stem exchanges foot and top, and left and
// right. Fails like with_role().
Result<PenSketch> with_line_turned(PenSketch sketch, scene::ItemId line);

// Returns the lines in use, by stem, for measure_stems() with Missing::Guessed: in millimetres of
// the sheet, or scaled so that the plant has the size in the document at which they were drawn.
enum class Unit { Sheet, Plant };
Result<std::vector<StemLines>> stem_sketches(PenSketch const& sketch, Unit unit = Unit::Sheet);

// Returns the current stem, whose lines are edited next: the stem drawn last, or the stem of the
// newest line. If that stem takes its organs from another one, returns the other stem.
Result<std::size_t> current_stem(PenSketch const& sketch);

// Returns a sketch of one of the stems alone.
PenSketch sketch_of_stem(PenSketch const& sketch, std::size_t stem);

// Returns the line that is the first stem; the plant stands at its foot.
SketchLine const& first_stem(PenSketch const& sketch);

// Returns the lines of the current stem, for measure_sketch() with Missing::Guessed.
Result<LineSketch> line_sketch(PenSketch const& sketch);

// Returns the number of an organ in the sketch, from 1; 0 if there is none.
std::size_t organ_number(PenSketch const& sketch, scene::ItemId organ);

// Returns the measured sketch with its organs, in millimetres of the plant. Fails like
// measure_stems() and surface_of().
Result<ComposedSketch> composed(PenSketch const& sketch);

// Returns the sketch's plant as a model in cpfg's language, named "lines".
Result<LineModel> model_of(PenSketch const& sketch);

Result<scene::BuiltSource> build_pen_sketch(PenSketch const& sketch,
                                            scene::LoadOptions const& options);

// A layer of nodes.
struct Layer {
    // The line that stores the number of nodes: the one below the layer, or the stem if there is
    // none.
    scene::ItemId line = 0;
    double from_x = 0;
    double to_x = 1;
    int nodes = 0;
};

// Returns the layers of the current stem, from below; at least one.
Result<std::vector<Layer>> layers_of(PenSketch const& sketch);

// Returns the layer beside a point on the sheet, for the nearest stem that has lines of its own;
// for a point beyond all layers, the nearest layer.
Result<Layer> layer_at(PenSketch const& sketch, Vec2 const& place_mm);

// Returns the line nearest to a point on the sheet, if one is within 15 mm.
std::optional<scene::ItemId> line_at(PenSketch const& sketch, Vec2 const& place_mm);

// Finds a line by id; null if there is none.
SketchLine const* find_line(PenSketch const& sketch, scene::ItemId line);

} // namespace tractus::lines
