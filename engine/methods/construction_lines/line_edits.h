#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <optional>
#include <string>

namespace tractus::lines {

// Edit: adds a line to a sketch and updates the plant. Items drawn on the plant's branches are
// kept.
struct AddLine {
    static scene::EditKind const kKind;

    // Id of the plant; 0: the line is the stem of a new plant, which becomes the active one.
    scene::ItemId plant = 0;
    Stroke stroke {}; // Stroke of the line, world frame.
    // True: the line is an additional stem of the plant, attached to another stem if it begins on
    // one, and separate otherwise.
    bool another_stem = false;
    // Source of the line's depth. Sessions recorded before boundaries had a depth lack this field.
    DepthBy depth_by = DepthBy::StemsHeight;
    // Method of finding the line's role. Sessions recorded before Reading::Together existed lack
    // this field.
    Reading reading = Reading::OneByOne;
    int nodes = 8; // Number of nodes in the layer above the line, if there is one; see SketchLine.
    // Pattern and scale of a new plant. The scale is in world millimetres per plant millimetre; a
    // document without a scale adopts it.
    Pattern pattern {};
    double scale = 0.1;
    Vec3 stands_at_mm = Vec3::Zero(); // Position of a new plant, world frame.
    scene::ItemId id = 0; // Id of the line, and of the plant that it begins; 0 if not assigned yet.
};

// Edit: sets the number of nodes of a layer.
struct SetLayerNodes {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0; // Line that owns the layer (see Layer).
    int nodes = 8;
};

// Edit: sets the arrangement of organs around the stem.
struct SetLinePattern {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Pattern pattern {};
    // Line that owns the layer (see Layer); 0: all layers, whose own patterns are then removed. A
    // new kind of pattern for all layers also removes the user's rules (PenSketch::rules).
    scene::ItemId line = 0;
};

// Edit: sets the role of a line of a sketch, see with_role().
struct SetLineRole {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
    Role role = Role::Unsure;
};

// Edit: replaces the stroke of a line, for example by one from bend_lines.h. The line keeps its
// role and its number of nodes.
struct RedrawLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
    Stroke stroke {}; // New stroke of the line, world frame.
};

// Edit: reverses a line, see with_line_turned().
struct TurnLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
};

// Edit: bends a stem, see with_heading().
struct BendStem {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0; // Id of the stem.
    int place = 0;          // Index of the place in kHeadingPlaces.
    double heading_deg = 0;
};

// Returns the sketch of a plant; null if the plant is of another kind.
PenSketch const* pen_sketch(scene::PlantState const& plant);

// Returns the active plant's sketch; null if there is no plant, or it has none.
PenSketch const* active_pen_sketch(scene::DocumentState const& state);

// Returns the placement of the plant's sheet on the tablet in a document with this scale.
SheetPlacement sheet_of(scene::PlantState const& plant, std::optional<double> scale);

// Describes for the user how the sketch's newest line was interpreted, and which line is still
// missing.
std::string describe_result(PenSketch const& sketch);

} // namespace tractus::lines
