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

// A plant that is drawn with construction lines: the source that its base plant is built from. It
// gives a plant at every stage. The stem alone is a bare stem, since nothing says yet how far
// organs reach; one boundary counts on both sides, one inclination line all along the stem, and
// without any organs lean by 45 degrees. Lines that nobody knows have no effect.
//
// It may have several stems, each with lines of its own; one without a boundary bears what another
// one does (several_stems.h). What follows speaks of one stem where it says so.
struct PenSketch {
    // In the order in which they were drawn; one that was drawn again has given its place up. At
    // least the stem.
    std::vector<SketchLine> lines;
    Pattern pattern {};
    double scale = 0.1; // World millimetres per plant millimetre, where a line's size is 1.
    std::vector<SketchOrgan> organs {}; // What layers may bear, in the order in which they came.
    scene::ItemId organ = 0;            // Which of them the plant bears; 0: plain leaves.
    // Rules in place of the pattern's, whose numbers stay those of the sketch (own_rules.h).
    std::optional<scene::SourceRules> rules {};
};

extern scene::SourceKind const kPenSketch;

// The sketch with one more line, whose role is found out from how it lies to the others
// (LineRecogniser), or, where they are read together, together with theirs (explain_sketch.h). It
// takes the place of one that it draws again, and that one's number of nodes.
// It is in space if its depth is to count and the surface has moved, while it was drawn, by more
// than a twentieth of the length of the stem that was drawn last.
//
// Fails, as the user's fault, for a dot, a stem that is too short, too many lines, and for a line
// with which the sketch gives no plant (measure_sketch()).
Result<PenSketch> with_line(PenSketch sketch, SketchLine line);

// The sketch with another stem: beside the others, or on the one on which it begins.
Result<PenSketch> with_stem(PenSketch sketch, SketchLine line);

// The sketch in which a line has the role that somebody says it has. The line of its stem that had
// it before is unsure from then on, but for inclination lines, of which there are many. Fails, as
// the user's fault, for a line that is not there, if no stem would be left, and if it gives no
// plant.
Result<PenSketch> with_role(PenSketch sketch, scene::ItemId line, Role role);

// The sketch in which a line has another stroke, drawn on the same sheet. Fails, as the user's
// fault, for a line that is not there, and if it gives no plant.
Result<PenSketch> with_other_stroke(PenSketch sketch, scene::ItemId line, Stroke stroke);

// The sketch in which a line goes the other way: of a stem its top is its foot from then on, and
// left and right are exchanged. Fails like with_role().
Result<PenSketch> with_line_turned(PenSketch sketch, scene::ItemId line);

// The lines that count, of each stem, as measure_stems() takes them with Missing::Guessed. In
// millimetres of the sheet, or so that their plant is as large in the document as they were drawn.
enum class Unit { Sheet, Plant };
Result<std::vector<StemLines>> stem_sketches(PenSketch const& sketch, Unit unit = Unit::Sheet);

// Whose lines one changes who goes on with the sketch: those by which organs stand on the stem that
// was drawn last, or to which the newest line belongs.
Result<std::size_t> stem_in_hand(PenSketch const& sketch);

// The sketch of one of its stems alone.
PenSketch stem_alone(PenSketch const& sketch, std::size_t stem);

// The line that is the first stem; the plant stands at its foot.
SketchLine const& first_stem(PenSketch const& sketch);

// The lines that count of the stem in hand, as measure_sketch() takes them with Missing::Guessed.
Result<LineSketch> line_sketch(PenSketch const& sketch);

// Which of the sketch's organs this is, from 1; 0: none of them.
std::size_t organ_number(PenSketch const& sketch, scene::ItemId organ);

// The sketch as measured, with its organs, in millimetres of the plant. Fails like measure_stems()
// and surface_of().
Result<ComposedSketch> composed(PenSketch const& sketch);

// The sketch's plant as a model in cpfg's language, called "lines".
Result<LineModel> model_of(PenSketch const& sketch);

Result<scene::BuiltSource> build_pen_sketch(PenSketch const& sketch,
                                            scene::LoadOptions const& options);

// A layer of nodes.
struct Layer {
    scene::ItemId line = 0; // Whose number of nodes it is: the line below it, or else the stem.
    double from_x = 0;
    double to_x = 1;
    int nodes = 0;
};

// The layers of the stem in hand, from below; at least one.
Result<std::vector<Layer>> layers_of(PenSketch const& sketch);

// The layer beside a place on the sheet, of the nearest stem that has lines of its own: of places
// below or above all of them the nearest one.
Result<Layer> layer_at(PenSketch const& sketch, Vec2 const& place_mm);

// The line nearest to a place on the sheet, if one is within 15 mm of it.
std::optional<scene::ItemId> line_at(PenSketch const& sketch, Vec2 const& place_mm);

// Null where there is none.
SketchLine const* find_line(PenSketch const& sketch, scene::ItemId line);

} // namespace tractus::lines
