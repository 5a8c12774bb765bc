#include "app/render/camera.h"

#include "engine/base/check.h"
#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::render {

// Share of the picture that the framed shape may fill; the rest is margin.
static constexpr double kFill = 0.94;
// Minimum distance from the eye to the framed shape, as a share of the shape's radius.
static constexpr double kMinClearance = 0.3;

Eigen::Matrix4f T_camera_world(Camera const& camera)
{
    Vec3 const back = (camera.eye_mm - camera.target_mm).normalized();
    Vec3 const right = camera.up.cross(back).normalized();
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose();
    matrix.block<1, 3>(1, 0) = back.cross(right).transpose();
    matrix.block<1, 3>(2, 0) = back.transpose();
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * camera.eye_mm;
    return matrix.cast<float>();
}

Eigen::Matrix4f projection_matrix(Camera const& camera, double aspect)
{
    CHECK(aspect > 0 && camera.far_mm > camera.near_mm);
    double const depth = camera.far_mm - camera.near_mm;
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    if (camera.projection == Camera::Projection::Perspective) {
        double const focal = 1 / std::tan(camera.field_of_view_rad / 2);
        matrix(0, 0) = focal / aspect;
        matrix(1, 1) = focal;
        matrix(2, 2) = -(camera.far_mm + camera.near_mm) / depth;
        matrix(2, 3) = -2 * camera.far_mm * camera.near_mm / depth;
        matrix(3, 2) = -1;
    } else {
        matrix(0, 0) = 2 / (camera.view_height_mm * aspect);
        matrix(1, 1) = 2 / camera.view_height_mm;
        matrix(2, 2) = -2 / depth;
        matrix(2, 3) = -(camera.far_mm + camera.near_mm) / depth;
        matrix(3, 3) = 1;
    }
    return matrix.cast<float>();
}

namespace {

// Returns how far the upright elliptic cylinder inscribed in `box` extends along a direction, which
// need not be a unit vector.
double reach(Bounds const& box, Vec3 const& direction)
{
    Vec3 const half = (box.max_mm - box.min_mm) / 2;
    Vec3 const stretched = half.cwiseProduct(direction);
    return direction.dot((box.min_mm + box.max_mm) / 2) + stretched.head<2>().norm()
        + std::abs(stretched.z());
}

Bounds not_empty(Bounds box)
{
    if (box.empty()) {
        box.add(Vec3(-50, -50, 0));
        box.add(Vec3(50, 50, 100));
    }
    return box;
}

// Unit vectors along the axes of a view.
struct ViewAxes {
    explicit ViewAxes(ViewAngles const& angles)
        : back(std::sin(angles.azimuth_rad) * std::cos(angles.elevation_rad),
               -std::cos(angles.azimuth_rad) * std::cos(angles.elevation_rad),
               std::sin(angles.elevation_rad))
        , right(Vec3::UnitZ().cross(back).normalized())
        , up(back.cross(right))
    {
    }

    Vec3 back;
    Vec3 right;
    Vec3 up;
};

// Slopes of the view pyramid's sides. They are smaller than the camera's by the factor kFill, which
// leaves the margin.
struct Slopes {
    explicit Slopes(double aspect)
        : up(std::tan(Camera().field_of_view_rad / 2) * kFill)
        , right(up * aspect)
    {
    }

    double up;
    double right;
};

// Returns the outward normals of the view pyramid's four sides, and the direction to the eye.
std::array<Vec3, 5> pyramid(ViewAxes const& axes, Slopes const& slopes)
{
    return { axes.back * slopes.up + axes.up, axes.back * slopes.up - axes.up,
             axes.back * slopes.right + axes.right, axes.back * slopes.right - axes.right,
             axes.back };
}

// Returns the camera that shows the framed shape as large as possible. `reach` contains the shape's
// extents along the directions of pyramid(): they say where each side of the view pyramid would
// touch the shape. The eye is centred between opposite sides, as far back as the wider pair
// requires, and at least kMinClearance away from the shape.
Camera touching_camera(ViewAngles const& angles, double aspect, std::array<double, 5> const& reach,
                       Bounds const& box)
{
    ViewAxes const axes(angles);
    Slopes const slopes(aspect);
    auto const [high, low, rightmost, leftmost, nearest] = reach;
    double const radius_mm = std::max(1.0, (box.max_mm - box.min_mm).norm() / 2);
    double const eye_back
        = std::max({ (high + low) / (2 * slopes.up), (rightmost + leftmost) / (2 * slopes.right),
                     nearest + kMinClearance * radius_mm });
    Camera camera;
    camera.eye_mm = axes.back * eye_back + axes.up * (high - low) / 2
        + axes.right * (rightmost - leftmost) / 2;
    Vec3 const center = (box.min_mm + box.max_mm) / 2;
    double const distance_mm = std::max(radius_mm, eye_back - center.dot(axes.back));
    camera.target_mm = camera.eye_mm - axes.back * distance_mm;
    camera.near_mm = std::max(distance_mm / 50, distance_mm - 3 * radius_mm);
    camera.far_mm = distance_mm + 20 * radius_mm;
    return camera;
}

} // namespace

Camera framing_camera(Bounds const& given_box, ViewAngles const& angles, double aspect)
{
    auto const box = not_empty(given_box);
    std::array<double, 5> reaches {};
    auto const directions = pyramid(ViewAxes(angles), Slopes(aspect));
    for (std::size_t i = 0; i < reaches.size(); ++i)
        reaches[i] = reach(box, directions[i]);
    return touching_camera(angles, aspect, reaches, box);
}

Framing::Framing(ViewAngles const& angles, double aspect)
    : angles_(angles)
    , aspect_(aspect)
    , directions_(pyramid(ViewAxes(angles), Slopes(aspect)))
{
    reach_.fill(-std::numeric_limits<double>::infinity());
}

void Framing::add(mesh::Mesh const& mesh)
{
    auto const box = mesh::bounds(mesh);
    if (box.empty())
        return;
    box_.add(box.min_mm);
    box_.add(box.max_mm);
    for (std::size_t i = 0; i < directions_.size(); ++i)
        reach_[i] = std::max(reach_[i], mesh::reach(mesh, directions_[i]));
}

Camera Framing::camera() const
{
    return box_.empty() ? framing_camera(box_, angles_, aspect_)
                        : touching_camera(angles_, aspect_, reach_, box_);
}

} // namespace tractus::render
