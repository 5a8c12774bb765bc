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

// What a person changes of a drawn leaf beside its lines. As it is, the leaf is as drawn.
struct LeafForm {
    double bend_deg = 0;       // Added to the midrib's bend, downwards: -180 to 180.
    double rise_deg = 0;       // Added to the blade's rise beside the midrib: -90 to 90.
    double vein_curve_deg = 0; // Side veins turn by that much more towards the tip: -90 to 90.
    double vein_width = 1;     // Times as wide: 0.2 to 5.
    int teeth = 0;             // On each half; 0: the margin is as drawn. At most 60.
    double tooth_depth = 0.02; // Of the blade's length: 0 to 0.2; only with teeth.
    double variation = 1;      // Times as much from leaf to leaf, for what wears them: 0 to 4.

    bool operator==(LeafForm const&) const = default;
};
Result<void> check_form(LeafForm const& form); // Refuses what is out of range, as the user's fault.

// A line of a leaf as a pen drew it.
struct LeafLine {
    scene::ItemId id = 0;
    Stroke stroke {}; // World frame: x and y on the tablet as on upright paper, z the height.
};

// What the lines of a sketch are, and the leaf in numbers.
struct SeenLeaf {
    RecognisedLeaf lines;
    LeafFit fit;
    bool is_midrib_guessed = false; // Its stroke is one more than there are then.
    // Why one of the lines is no part of the leaf, which is then as without it; its role is that of
    // a finer vein. Empty: all are.
    std::string left_out {};
};

// A leaf that is drawn on paper which stands upright (engine/scene/paper.h): the source of a plant.
// Depth towards the viewer is the surface's height above where the first line began. It gives a
// plant at every stage: lines that are no leaf yet are stems along them.
struct LeafSketch {
    static scene::SourceKind const kKind;

    std::vector<LeafLine> lines {}; // At least one, in the order in which they were drawn.
    LeafForm form {};
    double scale = 0.1; // World millimetres per plant millimetre.
    // What the lines are; null: no leaf yet. It follows from them: with_line() sets it.
    std::shared_ptr<SeenLeaf const> seen {};
    // Of which leaf of the kind it is the source; none: the one that was drawn.
    std::optional<std::uint64_t> seed {};
    double spread = 1;
};

// The sketch's lines in millimetres of the paper: (x, y, depth).
Result<LeafDrawing> drawing_of(LeafSketch const& sketch);

// Where the plant stands on the paper: below its lowest place. Fails where tips cannot be read.
Result<Vec2> foot_of(LeafSketch const& sketch);

// What the lines are. A closed line without a midrib has one from where the pen began to its
// farthest point, an open one that is alone from end to end. Where all lines give no leaf, one of
// the newest is left out. Fails, as the user's fault, like recognise_leaf() and fit_leaf().
Result<SeenLeaf> see_leaf(LeafSketch const& sketch);

// The sketch with one more line, which takes the place of one that it draws again: a closed line
// that of the closed one around which it lies or in which, any other one that of a line that it
// follows within 2.5 mm. Fails, as the user's fault, for a dot and for more than 200 lines.
Result<LeafSketch> with_line(LeafSketch sketch, LeafLine line);

// Without one of them. Fails, as the user's fault, for one that is not there and for the last one.
Result<LeafSketch> without_line(LeafSketch sketch, scene::ItemId line);

// The numbers of the leaf that was drawn, with what the form changes; no value: it is none yet.
std::optional<DrawnLeaf> formed_leaf(LeafSketch const& sketch);

// As a grammar's text, for plants that wear it and for people (print_grammar()). Fails, as the
// user's fault, where the lines are no leaf yet.
Result<std::string> grammar_text(LeafSketch const& sketch, std::string const& title);

// The plant: as large as drawn when it is shown at its scale, the place of foot_of() at the origin.
// The blade is as in the drawing; its veins and limb are polygons on the end of its stalk. Fails,
// as the user's fault, for a form that check_form() refuses, or with which the grammar gives none.
Result<scene::BuiltSource> build_leaf(LeafSketch const& sketch,
                                      scene::LoadOptions const& options = {});

} // namespace tractus::leaf
