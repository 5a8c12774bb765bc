#pragma once

#include "engine/plant/bezier_patch.h"
#include "engine/plant/cut_leaf.h"
#include "engine/plant/material.h"
#include "engine/plant/organ_calendar.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

// Index into Plant::organ_shapes.
using OrganShapeId = std::uint16_t;

// Looks of an organ at scale 1, as parameters; engine/mesh makes its triangles.
//
// Organ frame: origin where the organ is attached, +y along its length (the turtle's heading),
// +x to its right, +z out of its upper (adaxial) side. All lengths in millimetres.
struct OrganShape {
    enum class Kind {
        Blade,   // A flat organ with a midrib: leaf, leaflet, petal, sepal, grass blade.
        Needle,  // A thin straight organ of diamond cross-section: conifer needle, stamen.
        Disc,    // A shallow dome on its rim: the head of a composite flower.
        Ball,    // A sphere or ellipsoid touching the origin: berry, bud, fruit.
        Surface, // Bézier patches: any of these, as modelled in an editor.
        Leaf,    // A flat shape cut out of a picture of a grown leaf, and bent.
    };

    std::string name = "leaf";
    Kind kind = Kind::Blade;
    MaterialId material = 0;
    double length_mm = 50; // Distance from the attachment to the tip, petiole included.
    double width_mm = 25;  // Greatest width.
    double petiole_mm = 0; // Bare stalk before the blade begins; Blade only.
    // Where the greatest width lies along the blade, 0 base to 1 tip; Blade only.
    double widest = 0.4;
    double tip_sharpness = 1;    // 0 round, 1 pointed, above 1 drawn out (acuminate); Blade only.
    double base_sharpness = 0.3; // Sharpness of the blade's base; Blade only.
    // Depth of the margin's lobes as a share of the half width, 0 entire; Blade only.
    double lobes = 0;
    int lobe_count = 0; // Lobes on each side; Blade only.
    // Angle by which each half is folded up about the midrib; Blade and Leaf.
    double fold_rad = 0.3;
    // The midrib bends down by this angle from base to tip; Blade, Needle and Leaf.
    double curl_rad = 0.4;
    // Surface only, where length_mm and width_mm are the sizes of its box along y and x.
    std::vector<BezierPatch> patches {};
    // Surface only: its back has triangles of its own, for materials that are opaque.
    bool has_back = false;
    // Leaf only, which has none without it. Shared by all copies of a shape, since plants are
    // copied often.
    std::shared_ptr<CutLeaf const> cut {};
    // When it is there in the course of a year. No value: as organs of its kind and material are
    // (engine/scene/season.h).
    std::optional<OrganCalendar> calendar {};
};

} // namespace tractus
