#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::lines {

// Returns the sketch with an additional organ. The sketch's first organ is assigned to the whole
// plant, later organs to the topmost layer of the current stem. Fails with a user error if there
// are too many organs, or the sketch would give no plant.
Result<PenSketch> with_organ(PenSketch sketch, SketchOrgan organ);

// Edit: draws a line of a leaf. The sketch's first leaf is assigned to the whole plant, later
// leaves to the topmost layer of the current stem.
struct DrawOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    // Id of the leaf to which the line belongs; 0: the line is the side of a new leaf.
    scene::ItemId organ = 0;
    OrganView view = OrganView::Side;
    OrganColor color = OrganColor::Leaf; // New colour of the leaf.
    Stroke stroke {};                    // Stroke of the line, world frame.
    scene::ItemId id = 0;                // Id of the line, and of the leaf that it begins.
};

// Edit: sets the picture of a leaf: the bytes of a PNG file. Its place on the leaf is described for
// OrganSurface::picture.
struct PaintOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId organ = 0; // Id of the leaf; 0: the leaf drawn last.
    std::string picture {};
};

// Edit: sets which organ grows at the nodes of a layer.
struct SetLayerOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;  // Line that owns the layer (see Layer); 0: all layers.
    scene::ItemId organ = 0; // Id of the organ; 0: plain leaves.
    // Id of another plant from which the organ is taken; 0: none. The organ is one of that plant's
    // organs or, if `organ` is 0, the plant itself in its present form. A copy is added to the
    // organs of the sketch.
    scene::ItemId of_plant = 0;
    scene::ItemId id = 0; // Id of the organ that is copied from `of_plant`.
};

} // namespace tractus::lines
