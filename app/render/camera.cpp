#include "app/render/camera.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus {

// The share of the picture that the framed shape may fill: the rest is air.
static constexpr double kFill = 0.94;

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

// How far the upright elliptic cylinder inside `box` reaches in a direction of any length.
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

} // namespace

Camera framing_camera(Bounds const& given_box, ViewAngles const& angles, double aspect)
{
    auto const box = not_empty(given_box);
    double const radius_mm = std::max(1.0, (box.max_mm - box.min_mm).norm() / 2);
    double const flat = std::cos(angles.elevation_rad);
    Vec3 const back(std::sin(angles.azimuth_rad) * flat, -std::cos(angles.azimuth_rad) * flat,
                    std::sin(angles.elevation_rad));
    Vec3 const right = Vec3::UnitZ().cross(back).normalized();
    Vec3 const up = back.cross(right);

    Camera camera;
    double const slope_up = std::tan(camera.field_of_view_rad / 2) * kFill;
    double const slope_right = slope_up * aspect;
    // The four planes of the view pyramid, pushed out until each touches the cylinder: the eye lies
    // in the middle between opposite planes, as far back as the wider pair asks.
    double const high = reach(box, back * slope_up + up);
    double const low = reach(box, back * slope_up - up);
    double const rightmost = reach(box, back * slope_right + right);
    double const leftmost = reach(box, back * slope_right - right);
    double const eye_back
        = std::max((high + low) / (2 * slope_up), (rightmost + leftmost) / (2 * slope_right));
    camera.eye_mm = back * eye_back + up * (high - low) / 2 + right * (rightmost - leftmost) / 2;
    Vec3 const center = (box.min_mm + box.max_mm) / 2;
    double const distance_mm = std::max(radius_mm, eye_back - center.dot(back));
    camera.target_mm = camera.eye_mm - back * distance_mm;
    camera.near_mm = std::max(distance_mm / 50, distance_mm - 3 * radius_mm);
    camera.far_mm = distance_mm + 20 * radius_mm;
    return camera;
}

} // namespace tractus
