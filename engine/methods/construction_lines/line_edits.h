#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <optional>
#include <string>

namespace tractus::lines {

// Adds a line to a sketch, whose plant follows it. What was drawn on the plant's branches stays.
struct AddLine {
    static scene::EditKind const kKind;

    scene::ItemId plant
        = 0;          // 0: the line is the stem of another plant, which becomes the active one.
    Stroke stroke {}; // World frame.
    // The line is another stem of the plant: beside the others, or where it begins on one, on that.
    bool another_stem = false;
    // Sessions of before boundaries had a depth do not say it.
    DepthBy depth_by = DepthBy::StemsHeight;
    Reading reading = Reading::OneByOne; // Sessions of before lines were read together say nothing.
    int nodes = 8; // In the layer above the line, if it bounds one; see SketchLine.
    // Of a plant that begins. Its scale as of sketch::GrowAlongStroke: world millimetres per plant
    // millimetre, which a document whose scale nobody has set keeps.
    Pattern pattern {};
    double scale = 0.1;
    Vec3 stands_at_mm = Vec3::Zero(); // World frame.
    scene::ItemId id = 0; // Of the line, and of the plant that it begins; 0: it has none yet.
};

// Sets how many nodes a layer has.
struct SetLayerNodes {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0; // The layer's: see Layer.
    int nodes = 8;
};

// Sets how organs stand around the stem.
struct SetLinePattern {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Pattern pattern {};
    // A layer's (see Layer), in which they stand so; 0: in all layers, of which none has a pattern
    // of its own from then on; another kind of pattern comes with its own rules, too.
    scene::ItemId line = 0;
};

// Says what a line of a sketch is: see with_role().
struct SetLineRole {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
    Role role = Role::Unsure;
};

// Puts another stroke in the place of a line's, which keeps its role and its nodes (bend_lines.h).
struct RedrawLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
    Stroke stroke {}; // World frame.
};

// Turns a line round: see with_line_turned().
struct TurnLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
};

// Bends a stem: see with_heading().
struct BendStem {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0; // The stem.
    int place = 0;          // Its number among kHeadingPlaces.
    double heading_deg = 0;
};

// The sketch that a plant is drawn with; null for a plant of another kind.
PenSketch const* pen_sketch(scene::PlantState const& plant);

// The active plant's sketch; null where there is no plant, or it was not drawn so.
PenSketch const* active_pen_sketch(scene::DocumentState const& state);

// Where the sheet of such a plant is on the tablet in a document of this scale.
SheetPlacement sheet_of(scene::PlantState const& plant, std::optional<double> scale);

// For the person who has drawn a sketch's newest line: what it was taken for, and what is missing
// still.
std::string said_of(PenSketch const& sketch);

} // namespace tractus::lines
