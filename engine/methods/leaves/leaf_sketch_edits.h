#pragma once

#include "engine/methods/leaves/leaf_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::leaf {

// Edit: adds a line to a leaf on paper, see with_line().
struct AddLeafLine {
    static scene::EditKind const kKind;

    // Id of the plant; 0: the line begins a new leaf, which becomes the active plant.
    scene::ItemId plant = 0;
    Stroke stroke {}; // Stroke of the line, world frame.
    // Adjustments to a new leaf. Like `scale` and `stands_at_mm`, used only if `plant` is 0.
    LeafForm form {};
    // World millimetres per plant millimetre for a new leaf. A document without a scale adopts it.
    double scale = 0.1;
    Vec3 stands_at_mm = Vec3::Zero(); // Position of a new leaf's foot (foot_of()), world frame.
    bool may_be_leaflet = false;      // As in LeafLine.
    scene::ItemId id = 0; // Id of the line, and of the plant that it begins; 0 if not assigned yet.
};

// Edit: removes a line of a leaf. A leaf's only line cannot be removed; use RemovePlant instead.
struct EraseLeafLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
};

// Edit: sets the adjustments to a drawn leaf.
struct FormLeaf {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    LeafForm form {};
};

// Returns the leaf sketch of a plant; null if the plant was not drawn as a leaf.
LeafSketch const* leaf_sketch(scene::PlantState const& plant);

// Returns the leaf sketch of the active plant; null if there is none.
LeafSketch const* active_leaf_sketch(scene::DocumentState const& state);

// Describes for the user which lines the leaf consists of and which are still missing.
std::string describe_result(LeafSketch const& sketch);

} // namespace tractus::leaf
