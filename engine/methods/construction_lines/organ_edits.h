#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::lines {

// Returns the sketch with an additional organ. The first is assigned to the whole plant, later ones
// to the topmost layer of the current stem. Fails with a user error if there are too many, or the
// sketch would give no plant.
Result<PenSketch> with_organ(PenSketch sketch, SketchOrgan organ);

// Edit: draws a line of a leaf. The first leaf is assigned to the whole plant, later ones to the
// topmost layer of the current stem.
struct DrawOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    // Leaf to which the line belongs; 0: the line begins a new leaf, as its side.
    scene::ItemId organ = 0;
    OrganView view = OrganView::Side;
    OrganColor color = OrganColor::Leaf; // New colour of the leaf.
    Stroke stroke {};                    // Stroke of the line, world frame.
    scene::ItemId id = 0;                // Id of the line, and of the leaf that it begins.
};

// Edit: sets the picture of a leaf, the bytes of a PNG file, placed as described for
// OrganSurface::picture.
struct PaintOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId organ = 0; // Id of the leaf; 0: the leaf drawn last.
    std::string picture {};
};

// Edit: sets the organs of a layer.
struct SetLayerOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;  // Line that owns the layer (see Layer); 0: all layers.
    scene::ItemId organ = 0; // Id of the organ; 0: plain leaves.
    // Id of a plant, 0 for none, from which the organ is taken: one of its organs or, if `organ` is
    // 0, the plant itself, in its present form. A copy is added to the organs of the sketch.
    scene::ItemId of_plant = 0;
    scene::ItemId id = 0; // Id of the added organ.
};

} // namespace tractus::lines
