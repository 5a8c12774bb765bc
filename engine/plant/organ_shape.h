#pragma once

#include "engine/base/vectors.h"
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

// A leaf that is part of an organ with several leaves, such as the spray of leaves of a twig.
struct LeafOfSpray {
    Vec3 base_mm = Vec3::Zero(); // Attachment of the leaf, in the organ frame.
    // Rotation from the leaf's frame, which is defined like the organ frame, to the organ frame.
    Quat orientation = Quat::Identity();
    double length_mm = 0;
    double width_mm = 0;
};

// Shape of an organ at scale 1, as parameters; engine/mesh makes the triangles.
//
// Organ frame: origin at the attachment, +y along the organ (the turtle's heading), +x to its
// right, +z out of its upper (adaxial) side. All lengths in millimetres.
struct OrganShape {
    enum class Kind {
        Blade,   // A flat organ with a midrib: leaf, leaflet, petal, sepal, grass blade.
        Needle,  // A thin straight organ with a diamond cross-section: conifer needle, stamen.
        Disc,    // A shallow dome: the head of a composite flower.
        Ball,    // A sphere or ellipsoid with its surface at the origin: berry, bud, fruit.
        Surface, // A surface of Bézier patches, as modelled in an editor; any kind of organ.
        Leaf,    // A flat shape cut out of the picture of a grown leaf, then bent.
    };

    std::string name = "leaf";
    Kind kind = Kind::Blade;
    MaterialId material = 0;
    double length_mm = 50; // Length from the attachment to the tip, including the petiole.
    double width_mm = 25;  // Greatest width of the organ.
    double petiole_mm = 0; // Length of the petiole, below the blade; Blade only.
    // Position of the greatest width along the blade, from 0 (base) to 1 (tip); Blade only.
    double widest = 0.4;
    double tip_sharpness = 1;    // 0 round, 1 pointed, above 1 acuminate; Blade only.
    double base_sharpness = 0.3; // As tip_sharpness, for the base of the blade; Blade only.
    // Depth of the margin's lobes as a share of the half width, 0 for an entire margin; Blade only.
    double lobes = 0;
    int lobe_count = 0; // Number of lobes on each side; Blade only.
    // Angle by which each half is folded up about the midrib; Blade and Leaf.
    double fold_rad = 0.3;
    // Angle by which the midrib bends down from base to tip; Blade, Needle and Leaf.
    double curl_rad = 0.4;
    // For Surface only; length_mm and width_mm are then the size of the bounding box along y and x.
    std::vector<BezierPatch> patches {};
    // For Surface only: true if the back has its own triangles, as opaque materials require.
    bool has_back = false;
    // For Surface only: the single leaves of which the shape consists, if it is a spray of leaves:
    // one patch for each, in the same order. Empty: the organ is not a spray.
    std::vector<LeafOfSpray> spray {};
    // The leaf's cut-out: required for Leaf, unused for other kinds. Shared by all copies of a
    // shape, since plants are copied often.
    std::shared_ptr<CutLeaf const> cut {};
    // When the organ is present during the year. Default: the calendar for its kind and material
    // (engine/scene/season.h).
    std::optional<OrganCalendar> calendar {};
};

} // namespace tractus
