#pragma once

#include "engine/base/vectors.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <array>

namespace tractus::render {

// Where one looks from. World frame, millimetres.
struct Camera {
    enum class Projection { Perspective, Orthographic };

    Vec3 eye_mm { 0, -1000, 300 };
    Vec3 target_mm = Vec3::Zero();
    Vec3 up = Vec3::UnitZ(); // Need not be perpendicular to the direction of view, nor may it be
                             // parallel.
    Projection projection = Projection::Perspective;
    double field_of_view_rad = 0.55; // Vertical; Perspective only.
    double view_height_mm = 1000;    // Height that the picture shows; Orthographic only.
    double near_mm = 10;             // Nothing nearer or farther is drawn.
    double far_mm = 10000;

    double distance_mm() const { return (target_mm - eye_mm).norm(); }
};

// Takes world coordinates to the camera's: x right, y up, looking along -z.
Eigen::Matrix4f T_camera_world(Camera const& camera);

// Takes the camera's coordinates to OpenGL's clip space. `aspect` is width over height.
Eigen::Matrix4f projection_matrix(Camera const& camera, double aspect);

// Direction of the view.
struct ViewAngles {
    // 0: from -y, where the person sits; growing: walking to the right, around the plant.
    double azimuth_rad = 0;
    double elevation_rad = 0.2; // Above the horizon; below pi/2.
};

// A perspective camera that sees what a plant fills of its box, an upright elliptic cylinder, in
// the middle of the picture with some air around it, and the ground beyond it. An empty box counts
// as one of 100 mm on the origin.
Camera framing_camera(Bounds const& box, ViewAngles const& angles, double aspect);

// Frames meshes by what they draw, and not by their boxes: a plant that leans into a corner of its
// box is not cut, and one that does not fill it is not small.
class Framing {
public:
    Framing(ViewAngles const& angles, double aspect);

    void add(mesh::Mesh const& mesh);

    // Sees all that was added, with some air around it. Nothing counts as 100 mm on the origin.
    Camera camera() const;

private:
    ViewAngles angles_;
    double aspect_;
    std::array<Vec3, 5> directions_; // Out of the view: up, down, right, left, and to the eye.
    std::array<double, 5> reach_;    // How far the meshes go there.
    Bounds box_;
};

} // namespace tractus::render
