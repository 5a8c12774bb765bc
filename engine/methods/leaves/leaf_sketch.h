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

// Adjustments to a drawn leaf; the defaults leave it as drawn.
struct LeafForm {
    double bend_deg = 0; // Angle added to the downward bend of the midrib, -180 to 180.
    // Angle added to the rise of the blade on both sides of the midrib, -90 to 90.
    double rise_deg = 0;
    double vein_curve_deg = 0; // Angle added to the side veins' turn towards the tip, -90 to 90.
    double vein_width = 1;     // Factor on the width of veins, 0.2 to 5.
    int teeth = 0; // Number of teeth on each half, at most 60; 0: the margin is as drawn.
    // Depth of the teeth as a share of the blade's length, 0 to 0.2; only used with teeth.
    double tooth_depth = 0.02;
    double variation = 1; // Factor on the variation between the leaves of a plant, 0 to 4.

    bool operator==(LeafForm const&) const = default;
};
// Checks a form. Fails with a user error if a value is out of range.
Result<void> check_form(LeafForm const& form);

// A drawn line of a leaf.
struct LeafLine {
    scene::ItemId id = 0;
    // Stroke in the world frame; x and y are taken as an upright sheet of paper, z is the height of
    // the surface.
    Stroke stroke {};
};

// Recognition result: the roles of the sketch's lines, and the leaf's parameters.
struct LeafRecognition {
    RecognisedLeaf lines;
    LeafFit fit;
    // True: the midrib was added; its index is one past the last stroke.
    bool is_midrib_guessed = false;
    // Reason why one line was ignored; that line has the role of a finer vein. Empty: all lines
    // were used.
    std::string left_out {};
};

// A leaf drawn on an upright sheet of paper (engine/scene/paper.h); the source of a plant. Depth
// towards the viewer is the surface's height relative to the beginning of the first line. It gives
// a plant at every stage: lines that do not form a leaf yet become stems.
struct LeafSketch {
    static scene::SourceKind const kKind;

    std::vector<LeafLine> lines {}; // Lines in order of drawing, at least one.
    LeafForm form {};
    double scale = 0.1; // World millimetres per plant millimetre.
    // Result of recognise_leaf_sketch(), kept up to date by with_line(); null: no leaf yet.
    std::shared_ptr<LeafRecognition const> seen {};
    // Seed of another leaf of the same kind; no value: the leaf as drawn.
    std::optional<std::uint64_t> seed {};
    double spread = 1;
};

// The sketch's lines on the paper, (x, y, depth) in millimetres.
Result<LeafDrawing> drawing_of(LeafSketch const& sketch);

// Position of the plant's base on the paper: the lowest point of its lines. Fails if the pen data
// cannot be read.
Result<Vec2> foot_of(LeafSketch const& sketch);

// Recognises a sketch. A closed line without a midrib gets one from where the pen began to the
// line's farthest point; a single open line is taken as a half outline with a midrib from end to
// end. If all lines together give no leaf, one of the newest is ignored. Fails with a user error
// like recognise_leaf() and fit_leaf().
Result<LeafRecognition> recognise_leaf_sketch(LeafSketch const& sketch);

// Adds a line, replacing the one that it redraws: a closed line replaces a closed line if one of
// them contains the other's centre; an open line replaces an open one that it follows within 2.5
// mm. Fails with a user error for a dot, or for more than 200 lines.
Result<LeafSketch> with_line(LeafSketch sketch, LeafLine line);

// Removes a line. Fails with a user error if there is no such line, or if it is the last one.
Result<LeafSketch> without_line(LeafSketch sketch, scene::ItemId line);

// The drawn leaf's parameters with the form's adjustments; no value if there is no leaf yet.
std::optional<DrawnLeaf> adjusted_leaf(LeafSketch const& sketch);

// The leaf as a grammar's text, for use on plants and for editing (print_grammar()). Fails with a
// user error if the lines do not form a leaf yet.
Result<std::string> grammar_text(LeafSketch const& sketch, std::string const& title);

// Builds the plant: as large as drawn when shown at its scale, with foot_of() at the origin. The
// blade is posed as in the drawing; veins and limb are polygons at the end of the petiole. Fails
// with a user error if check_form() refuses the form, or if the grammar gives no leaf with it.
Result<scene::BuiltSource> build_leaf(LeafSketch const& sketch,
                                      scene::LoadOptions const& options = {});

} // namespace tractus::leaf
