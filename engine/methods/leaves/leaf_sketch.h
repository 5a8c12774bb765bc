#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/scene/anchored.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::leaf {

// Adjustments to a drawn leaf. With the default values the leaf stays as drawn.
struct LeafForm {
    double bend_deg = 0; // Angle added to the downward bend of the midrib, -180 to 180.
    // Angle added to the rise of the blade on both sides of the midrib, -90 to 90.
    double rise_deg = 0;
    // Angle added to the turn of side veins towards their parent's tip, -90 to 90.
    double vein_curve_deg = 0;
    double vein_width = 1; // Factor on the width of all veins, 0.2 to 5.
    int teeth = 0;         // Number of teeth on each half, at most 60; 0: the margin is as drawn.
    // Depth of the teeth as a share of the blade's length, 0 to 0.2; used only if `teeth` is above
    // 0.
    double tooth_depth = 0.02;
    double variation = 1; // Factor on the variation between the leaves of a plant, 0 to 4.

    bool operator==(LeafForm const&) const = default;
};
// Fails with a user error if a value of the form is out of range.
Result<void> check_form(LeafForm const& form);

// A drawn line of a leaf.
struct LeafLine {
    scene::ItemId id = 0;
    // Stroke in the world frame: x and y are positions on an upright sheet of paper, z is the
    // height of the drawing surface.
    Stroke stroke {};
    // True if several closed lines may be leaflets. A sketch is a compound leaf only if this is
    // true for all of its lines; it is false for lines of older drawings.
    bool may_be_leaflet = false;
};

// Result of recognising a leaf sketch: the roles of its lines, and the leaf's parameters.
struct LeafRecognition {
    RecognisedLeaf lines;
    LeafFit fit;
    // True: the midrib was not drawn but guessed; its role comes after those of all drawn lines.
    bool is_midrib_guessed = false;
    // Reason why one line was ignored, which then has the role of a finer vein. Empty if all lines
    // were used.
    std::string left_out {};
};

// A leaf drawn on an upright sheet of paper (engine/scene/paper.h); the source of a plant. Depth
// towards the viewer is the surface's height relative to the beginning of the first line. The
// sketch gives a plant at every stage: while its lines do not form a leaf, they become stems.
struct LeafSketch {
    static scene::SourceKind const kKind;

    std::vector<LeafLine> lines {}; // Lines in order of drawing, at least one.
    LeafForm form {};
    double scale = 0.1; // World millimetres per plant millimetre.
    // Result of recognise_leaf_sketch(), updated by with_line() and without_line(); null while the
    // lines form no leaf.
    std::shared_ptr<LeafRecognition const> seen {};
    // Seed of a random variation of the leaf; no value: the leaf as drawn.
    std::optional<std::uint64_t> seed {};
    double spread = 1;
};

// Returns the sketch's lines on the paper, (x, y, depth) in millimetres.
Result<LeafDrawing> drawing_of(LeafSketch const& sketch);

// Returns the position of the plant's base on the paper: the lowest point of the sketch's lines.
// Fails if the pen data cannot be read.
Result<Vec2> foot_of(LeafSketch const& sketch);

// Recognises a leaf sketch. A closed line without a midrib gets one from the line's first point to
// the point farthest from it. A single open line is taken as a half outline, with a midrib from end
// to end. If all lines together give no leaf, one of the newest four is ignored. Fails with a user
// error like recognise_leaf() and fit_leaf().
Result<LeafRecognition> recognise_leaf_sketch(LeafSketch const& sketch);

// Returns the sketch with one more line. It replaces a line that it redraws: a closed line replaces
// a closed line if one of them contains the other's centre; an open line replaces an open one that
// it follows within 2.5 mm. Fails with a user error for a dot, or for more than 200 lines.
Result<LeafSketch> with_line(LeafSketch sketch, LeafLine line);

// Returns the sketch without a line. Fails with a user error if there is no such line, or if no
// other line would be left.
Result<LeafSketch> without_line(LeafSketch sketch, scene::ItemId line);

// Returns the drawn leaf's parameters with the adjustments of LeafForm; no value if the lines do
// not form a leaf yet.
std::optional<DrawnLeaf> adjusted_leaf(LeafSketch const& sketch);

// Returns the leaf as a grammar's text (print_grammar()), for use on plants and for editing. Fails
// with a user error if the lines do not form a leaf yet.
Result<std::string> grammar_text(LeafSketch const& sketch, std::string const& title);

// Builds the plant of a leaf sketch. At the sketch's scale it is as large as drawn, with foot_of()
// at the origin. The blade is posed as in the drawing; veins and limb are polygons at the end of
// the petiole. Fails with a user error if check_form() refuses the form, or if the grammar gives no
// leaf with it.
Result<scene::BuiltSource> build_leaf(LeafSketch const& sketch,
                                      scene::LoadOptions const& options = {});

} // namespace tractus::leaf
