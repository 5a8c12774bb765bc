#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/projected_skeleton.h"

namespace tractus::scene {

// The volume above the desk that the pen can reach: a box on the desk, centred on the world's
// origin. World frame, millimetres.
struct DrawingVolume {
    double width_mm = 254;  // Along x: width of the tablet's active area.
    double depth_mm = 159;  // Along y: depth of the tablet's active area.
    double height_mm = 300; // Along z: most of the surface's travel.
};

// Position and scale of a plant in the drawing volume. Converts between world millimetres, in which
// strokes are given, and millimetres of the plant's own frame, at natural size.
struct DeskPlacement {
    double scale = 1;              // World millimetres per plant millimetre.
    Vec3 origin_mm = Vec3::Zero(); // Position of the plant's base, world frame.

    Vec3 world_of_plant(Vec3 const& plant_mm) const { return origin_mm + scale * plant_mm; }
    Vec3 plant_of_world(Vec3 const& world_mm) const { return (world_mm - origin_mm) / scale; }

    // Height of the plant as displayed in the volume, in world millimetres. The length of a motion
    // indicator is measured relative to it.
    double shown_height_mm = 1;
};

// Returns the placement of a single plant with its base at the world's origin. The scale is the
// largest at which the plant's height fits the volume's height and twice its greatest horizontal
// distance from the base fits the volume's width.
DeskPlacement place_on_desk(Plant const& plant, DrawingVolume const& volume = {});

// Changes the scale, and the displayed height in proportion.
void rescale(DeskPlacement& placement, double scale);

// Viewing angle and zoom of the selection view.
struct SelectionAngle {
    // Direction of view: 0 is from the front, looking along +y. The angle increases as the viewer
    // walks round the plant to the right.
    double azimuth_deg = 0;
    double elevation_deg = 0; // Angle of the viewer above the horizon; below 90.
    // Magnification about the tablet's centre: 1 fits the plant to the tablet's active area.
    double zoom = 1;
    Vec2 moved_mm = Vec2::Zero();  // Displacement of the displayed plant on the tablet.
    Vec2 area_mm = Vec2(254, 159); // Size of the tablet's active area.
    // Whether the skeleton is displayed at rest or as bent by strokes. In both cases the view is
    // fitted to the plant at rest, so that the view does not move when a stroke bends the plant.
    enum class Shape { AtRest, AsBent } shape = Shape::AtRest;

    bool operator==(SelectionAngle const&) const = default;
};

// The projection by which the selection view shows the skeleton on the tablet: orthographic, and
// scaled to fit the tablet with a margin. Results are in millimetres from the tablet's centre: the
// x and y of the world frame, whatever the surface's height.
struct SelectionView {
    double scale = 1; // Tablet millimetres per plant millimetre.
    // Position of the plant's base on the tablet, in millimetres from the tablet's centre.
    Vec2 origin_mm = Vec2::Zero();
    std::uint32_t max_order = 1; // Axes of a higher order are hidden.
    // Unit vectors in the plant's frame that point right, up, and towards the viewer.
    Vec3 right = Vec3::UnitX();
    Vec3 up = Vec3::UnitZ();
    Vec3 back = -Vec3::UnitY();
    Vec2 area_mm = Vec2(254, 159); // Size of the tablet's active area.
    Vec2 size_mm = Vec2::Zero();   // Size on the tablet of the plant's bounding box.

    Vec2 tablet_of_plant(Vec3 const& plant_mm) const
    {
        return origin_mm + scale * Vec2(right.dot(plant_mm), up.dot(plant_mm));
    }
};

// Converts a selection view to a projection for picking branches. The projection's u and v are
// millimetres from the tablet's centre.
variation::SkeletonProjection skeleton_projection(SelectionView const& view);

SelectionView fit_selection_view(Plant const& plant, SelectionAngle const& angle = {});

// Fits the view to a bounding box alone, for a plant of which only that is known; max_order keeps
// its default.
SelectionView fit_selection_view(Bounds const& box, SelectionAngle const& angle = {});

} // namespace tractus::scene
