#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/projected_skeleton.h"

namespace tractus::scene {

// The volume above the desk in which a hand can draw. World frame, millimetres: it stands on the
// desk and is centred on the world's origin.
struct DrawingVolume {
    double width_mm = 254;  // Along x: the tablet's active area.
    double depth_mm = 159;  // Along y.
    double height_mm = 300; // Along z: most of the surface's travel.
};

// Where and how large a plant is shown in the drawing volume. Strokes live in world millimetres,
// plants in their own frame at natural size; this joins the two.
struct DeskPlacement {
    double scale = 1;              // World millimetres per plant millimetre.
    Vec3 origin_mm = Vec3::Zero(); // Of the plant's frame: its base. World frame.

    Vec3 world_of_plant(Vec3 const& plant_mm) const { return origin_mm + scale * plant_mm; }
    Vec3 plant_of_world(Vec3 const& world_mm) const { return (world_mm - origin_mm) / scale; }

    // The plant's height as it stands in the volume: what a motion indicator's length is measured
    // by.
    double shown_height_mm = 1;
};

// The plant alone, its base at the world's origin, in the largest size at which its height fits and
// its spread, to all sides alike, fits the volume's width.
DeskPlacement place_on_desk(Plant const& plant, DrawingVolume const& volume = {});

// Shows it in another size.
void rescale(DeskPlacement& placement, double scale);

// From where the selection view looks at the skeleton, and how near.
struct SelectionAngle {
    double azimuth_deg = 0;        // 0: from the front, along +y; growing: walking to the right.
    double elevation_deg = 0;      // Above the horizon; below 90.
    double zoom = 1;               // 2 shows everything twice as large, about the tablet's centre.
    Vec2 moved_mm = Vec2::Zero();  // By this on the tablet.
    Vec2 area_mm = Vec2(254, 159); // The tablet's active area, which the plant fits at zoom 1.
    // Whether the skeleton is seen as strokes have bent it. What fits the area is the plant at rest
    // in either case, so that the view keeps still while one draws.
    enum class Shape { AtRest, AsBent } shape = Shape::AtRest;

    bool operator==(SelectionAngle const&) const = default;
};

// The skeleton as the selection view shows it on the tablet: orthographic, the plant's frame scaled
// to fit the tablet with a margin. Tablet-centred millimetres are the x and y of the world frame,
// whatever the surface's height.
struct SelectionView {
    double scale = 1;              // Tablet millimetres per plant millimetre.
    Vec2 origin_mm = Vec2::Zero(); // Where the plant's base is shown.
    std::uint32_t max_order = 1;   // Axes of a higher order are not shown.
    // Unit vectors of the plant's frame that point right, up, and at who looks.
    Vec3 right = Vec3::UnitX();
    Vec3 up = Vec3::UnitZ();
    Vec3 back = -Vec3::UnitY();
    Vec2 area_mm = Vec2(254, 159); // The tablet's,
    Vec2 size_mm = Vec2::Zero();   // and what of it the plant's box takes up.

    Vec2 tablet_of_plant(Vec3 const& plant_mm) const
    {
        return origin_mm + scale * Vec2(right.dot(plant_mm), up.dot(plant_mm));
    }
};

// The same as a projection, for picking: u and v are tablet-centred millimetres.
variation::SkeletonProjection skeleton_projection(SelectionView const& view);

SelectionView fit_selection_view(Plant const& plant, SelectionAngle const& angle = {});

// Of a plant of which only its box is known; the order is the default's.
SelectionView fit_selection_view(Bounds const& box, SelectionAngle const& angle = {});

} // namespace tractus::scene
