#pragma once

#include "engine/base/vectors.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <array>

namespace tractus::render {

// Point of view and projection of a picture. World frame, millimetres.
struct Camera {
    enum class Projection { Perspective, Orthographic };

    Vec3 eye_mm { 0, -1000, 300 };
    Vec3 target_mm = Vec3::Zero();
    // Need not be perpendicular to the viewing direction, but must not be parallel to it.
    Vec3 up = Vec3::UnitZ();
    Projection projection = Projection::Perspective;
    double field_of_view_rad = 0.55; // Vertical angle of view; only for Perspective.
    double view_height_mm = 1000;    // Visible height; only for Orthographic.
    double near_mm = 10;             // Distance from the eye to the near clipping plane.
    double far_mm = 10000;

    double distance_mm() const { return (target_mm - eye_mm).norm(); }
};

// Returns the transform from world to camera coordinates, in which x points right, y points up and
// the camera looks along -z.
Eigen::Matrix4f T_camera_world(Camera const& camera);

// Returns the transform from camera coordinates to OpenGL's clip space. `aspect` is the picture's
// width divided by its height.
Eigen::Matrix4f projection_matrix(Camera const& camera, double aspect);

// Direction from which a camera looks.
struct ViewAngles {
    // At 0 the camera looks from -y, where the user sits; at greater angles from farther to the
    // right.
    double azimuth_rad = 0;
    double elevation_rad = 0.2; // Angle of the camera above the horizon, less than pi/2.
};

// Returns a perspective camera that centres a plant with some margin and shows the ground beyond
// it. The plant is assumed to fill an upright elliptic cylinder inside its bounding box. An empty
// box is treated as a box of 100 mm at the origin.
Camera framing_camera(Bounds const& box, ViewAngles const& angles, double aspect);

// Fits a camera to the geometry of meshes rather than to their bounding boxes. A plant that leans
// into a corner of its box is then not cut off, and one that does not fill its box is not shown
// small.
class Framing {
public:
    Framing(ViewAngles const& angles, double aspect);

    void add(mesh::Mesh const& mesh);

    // Returns a camera that shows all meshes added so far, with some margin. Without meshes it
    // shows a box of 100 mm at the origin.
    Camera camera() const;

private:
    ViewAngles angles_;
    double aspect_;
    // Normals of the view pyramid's upper, lower, right and left sides, and the direction to the
    // eye.
    std::array<Vec3, 5> directions_;
    std::array<double, 5> reach_; // Extent of the meshes along each of directions_.
    Bounds box_;
};

} // namespace tractus::render
