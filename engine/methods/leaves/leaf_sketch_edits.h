#pragma once

#include "engine/methods/leaves/leaf_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::leaf {

// Adds a line to a leaf on paper: see with_line().
struct AddLeafLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0; // 0: the line begins another leaf, which becomes the active plant.
    Stroke stroke {};        // World frame.
    // Of a leaf that begins.
    LeafForm form {};
    double scale = 0.1;               // A document whose scale nobody has set keeps it.
    Vec3 stands_at_mm = Vec3::Zero(); // Of foot_of(). World frame.
    scene::ItemId id = 0; // Of the line, and of the plant that it begins; 0: it has none yet.
};

// Takes a line of a leaf away. Its last one is refused: RemovePlant takes the whole.
struct EraseLeafLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
};

// Sets what is changed of a leaf beside its lines.
struct FormLeaf {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    LeafForm form {};
};

// Null for a plant that was not drawn as a leaf.
LeafSketch const* leaf_sketch(scene::PlantState const& plant);

// The active plant's; null where there is none, or it was not drawn so.
LeafSketch const* active_leaf_sketch(scene::DocumentState const& state);

// Says what there is of a leaf, and what it still lacks, to the person who draws it.
std::string said_of(LeafSketch const& sketch);

} // namespace tractus::leaf
