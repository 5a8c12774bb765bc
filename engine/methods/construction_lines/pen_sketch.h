#pragma once

#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/pattern.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "engine/methods/construction_lines/recognise_stems.h"
#include "engine/scene/anchored.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <vector>

namespace tractus::lines {

// Where on a sketch's sheet (drawn_line.h) a place on the tablet is, which is upright paper
// (paper.h): offset + size * (x, y). As long as a plant is shown in the size in which its stem was
// drawn, both are the same.
struct SheetPlacement {
    Vec2 offset_mm = Vec2::Zero();
    double size = 1; // Millimetres of the sheet in one of the tablet; above 0.

    Vec2 on_sheet(Vec2 const& tablet_mm) const { return offset_mm + size * tablet_mm; }
    Vec2 on_tablet(Vec2 const& sheet_mm) const { return (sheet_mm - offset_mm) / size; }
};

// Where a line's depth comes from.
enum class DepthBy {
    StemsHeight, // A stem's from the surface's height; all other lines are on the sheet.
    Height,      // From the surface's height, of boundaries, too: see Role::Around.
    Pressure,    // A stem's from the pen's pressure: where there is no sensor for the height.
};

// A line of a sketch as a pen drew it.
struct SketchLine {
    scene::ItemId id = 0;
    Stroke stroke {};        // World frame.
    SheetPlacement sheet {}; // When it was drawn.
    Role role = Role::Unsure;
    // In the layer above it, of an inclination line, 0 to kMostNodesInLayer. Of the stem: in the
    // only layer of a sketch with fewer than two of those.
    int nodes = 0;
    std::size_t stem = 0; // The number of the stem to which it belongs; of a stem, its own.
    std::optional<std::size_t> parent {}; // Of a stem: see StemLines.
    DepthBy depth_by = DepthBy::StemsHeight;
    // The surface's height where the depth is 0, that at which its stem begins, mm on the tablet.
    // No value: the line does not leave the sheet, or it is a stem.
    std::optional<double> level_mm {};
};

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
};

extern scene::SourceKind const kPenSketch;

// Where the tips of a line are on the sheet, (u, v, depth), the hand's tremor taken out
// (capture_line.h). Where the surface has moved by less than a twentieth of the line's length the
// depth is 0; else it is the height above pen-down, or of a line that has a level above that. By
// pressure a stem comes towards the viewer by half of its length on the sheet where the pen is
// pressed with all of its range more than at its base; the mean of a twentieth of the stem counts,
// and at its ends, where the pen comes down and is lifted, what is a twentieth from them. At
// least two points, no two neighbours at one
// place of the sheet. Fails, as the user's fault, for a dot.
Result<std::vector<Vec3>> points_on_sheet(SketchLine const& line);

// The sketch with one more line, whose role is found out from how it lies to the others
// (LineRecogniser). It takes the place of one that it draws again, and that one's number of nodes.
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
