#pragma once

#include "engine/base/vectors.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <array>

namespace tractus::render {

// Point of view and projection. World frame, millimetres.
struct Camera {
    enum class Projection { Perspective, Orthographic };

    Vec3 eye_mm { 0, -1000, 300 };
    Vec3 target_mm = Vec3::Zero();
    // Need not be perpendicular to the viewing direction, but must not be parallel to it.
    Vec3 up = Vec3::UnitZ();
    Projection projection = Projection::Perspective;
    double field_of_view_rad = 0.55; // Vertical angle; Perspective only.
    double view_height_mm = 1000;    // Visible height; Orthographic only.
    double near_mm = 10;             // Near clipping distance.
    double far_mm = 10000;

    double distance_mm() const { return (target_mm - eye_mm).norm(); }
};

// Transforms world coordinates to camera coordinates: x right, y up, looking along -z.
Eigen::Matrix4f T_camera_world(Camera const& camera);

// Transforms camera coordinates to OpenGL's clip space. `aspect` is width divided by height.
Eigen::Matrix4f projection_matrix(Camera const& camera, double aspect);

// Direction from which a camera looks.
struct ViewAngles {
    // Azimuth: 0 looks from -y, where the user sits; greater angles look from farther right.
    double azimuth_rad = 0;
    double elevation_rad = 0.2; // Angle above the horizon, less than pi/2.
};

// A perspective camera that centres a plant with some margin and shows the ground beyond it. The
// plant is assumed to fill an upright elliptic cylinder inside its box. An empty box counts as one
// of 100 mm at the origin.
Camera framing_camera(Bounds const& box, ViewAngles const& angles, double aspect);

// Frames meshes by their geometry rather than by their bounding boxes, so that a plant leaning into
// a corner of its box is not cut off and one that does not fill it is not shown small.
class Framing {
public:
    Framing(ViewAngles const& angles, double aspect);

    void add(mesh::Mesh const& mesh);

    // A camera that shows everything added, with some margin. Without meshes it shows 100 mm at the
    // origin.
    Camera camera() const;

private:
    ViewAngles angles_;
    double aspect_;
    std::array<Vec3, 5> directions_; // View directions: up, down, right, left, and to the eye.
    std::array<double, 5> reach_;    // Extent of the meshes in each direction.
    Bounds box_;
};

} // namespace tractus::render
