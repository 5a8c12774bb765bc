#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::lines {

// The sketch with another organ. The first one is borne by the whole plant, and later ones by the
// topmost layer of the stem in hand. Fails, as the user's fault, for too many, and for one with
// which the sketch gives no plant.
Result<PenSketch> with_organ(PenSketch sketch, SketchOrgan organ);

// Draws a line of a leaf. A leaf that begins is borne by the whole plant if it is the first one,
// and else by the topmost layer of the stem in hand.
struct DrawOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId organ = 0; // 0: the line begins another one, as a side.
    OrganView view = OrganView::Side;
    OrganColor color = OrganColor::Leaf; // The leaf has it from now on.
    Stroke stroke {};                    // World frame.
    scene::ItemId id = 0;                // The line's, and that of the leaf that it begins.
};

// Lets a leaf show a picture: the bytes of a PNG file that lies on it as OrganSurface::picture
// does.
struct PaintOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId organ = 0; // 0: the newest leaf that was drawn.
    std::string picture {};
};

// Says what stands in a layer.
struct SetLayerOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;  // The layer's: see Layer. 0: in all layers.
    scene::ItemId organ = 0; // 0: plain leaves.
    // If not 0: the organ is that plant's, as it is now, and 0 is the plant itself. It is taken as
    // another organ of this one.
    scene::ItemId of_plant = 0;
    scene::ItemId id = 0; // An organ's that is taken.
};

} // namespace tractus::lines
