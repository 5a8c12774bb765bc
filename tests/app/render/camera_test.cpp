#include "app/render/camera.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::render {

namespace {

Eigen::Vector4f clip(Camera const& camera, double aspect, Vec3 const& point)
{
    return projection_matrix(camera, aspect) * T_camera_world(camera)
        * point.cast<float>().homogeneous();
}

Vec3f on_screen(Camera const& camera, double aspect, Vec3 const& point)
{
    return clip(camera, aspect, point).hnormalized();
}

} // namespace

TEST(Camera, SeesItsTargetInTheMiddle)
{
    Camera camera;
    camera.target_mm = Vec3(10, 20, 30);
    auto const place = on_screen(camera, 1.5, camera.target_mm);
    EXPECT_NEAR(place.x(), 0, 1e-5);
    EXPECT_NEAR(place.y(), 0, 1e-5);
}

TEST(Camera, HasRightOnTheRightAndUpAtTheTop)
{
    Camera const camera; // The default camera is on the user's side.
    EXPECT_GT(on_screen(camera, 1, Vec3(50, 0, 0)).x(), 0.05f);
    EXPECT_GT(on_screen(camera, 1, Vec3(0, 0, 50)).y(), 0.05f);
}

TEST(Camera, ShowsNearAndFarAlikeWhenOrthographic)
{
    Camera camera { .eye_mm = { 0, -1000, 0 },
                    .projection = Camera::Projection::Orthographic,
                    .view_height_mm = 400 };
    EXPECT_NEAR(on_screen(camera, 2, Vec3(0, -500, 100)).y(), 0.5, 1e-5);
    EXPECT_NEAR(on_screen(camera, 2, Vec3(0, 900, 100)).y(), 0.5, 1e-5);
    EXPECT_NEAR(on_screen(camera, 2, Vec3(400, 0, 0)).x(), 1.0, 1e-5);
}

TEST(FramingCamera, SeesAPlantFromEverySideWithAir)
{
    Bounds box;
    box.add(Vec3(-300, -900, 0));
    box.add(Vec3(1200, 500, 2500));
    Vec3 const center = (box.min_mm + box.max_mm) / 2;
    for (double azimuth = 0; azimuth < 6; azimuth += 0.7) {
        auto const camera = framing_camera(box, { azimuth, 0.3 }, 1.33);
        float most = 0;
        for (double turn = 0; turn < 6.28; turn += 0.1)
            for (double const height : { box.min_mm.z(), box.max_mm.z() }) {
                Vec3 const rim(center.x() + 750 * std::cos(turn), center.y() + 700 * std::sin(turn),
                               height);
                auto const place = on_screen(camera, 1.33, rim);
                most = std::max({ most, std::abs(place.x()), std::abs(place.y()) });
                EXPECT_LT(std::abs(place.z()), 1) << "cut by the near or far plane";
            }
        EXPECT_LT(most, 0.95f) << "azimuth " << azimuth;
        EXPECT_GT(most, 0.80f) << "azimuth " << azimuth;
    }
}

// Returns poles that lean from the origin towards the eight corners of a box. If `only` is less
// than 8, returns only the pole with that number.
mesh::Mesh leaning_poles(std::size_t only)
{
    mesh::Mesh mesh;
    auto& surface = mesh.surfaces.emplace_back();
    for (std::size_t pole = 0; pole < 8; ++pole)
        if (only == 8 || only == pole) {
            Vec3f const tip(pole & 1 ? 1000.f : -1000.f, pole & 2 ? 1000.f : -1000.f,
                            pole & 4 ? 1400.f : 600.f);
            surface.positions_mm.insert(surface.positions_mm.end(),
                                        { Vec3f(0, 0, 0), Vec3f(20, 0, 0), tip });
        }
    return mesh;
}

TEST(Framing, CutsNothingThatLeansIntoACornerOfItsBox)
{
    for (std::size_t pole = 0; pole <= 8; ++pole)
        for (double azimuth = 0; azimuth < 6; azimuth += 0.4)
            for (double const aspect : { 0.6, 1.0, 1.8 }) {
                auto const mesh = leaning_poles(pole);
                Framing framing({ azimuth, 0.3 }, aspect);
                framing.add(mesh);
                auto const camera = framing.camera();
                float most = 0;
                for (auto const& point : mesh.surfaces[0].positions_mm) {
                    auto const place = on_screen(camera, aspect, point.cast<double>());
                    most = std::max({ most, std::abs(place.x()), std::abs(place.y()) });
                    EXPECT_LT(std::abs(place.z()), 1) << "cut by the near or far plane";
                }
                EXPECT_LT(most, 0.95f) << "azimuth " << azimuth;
                // All poles together fill the picture. A single one may point at the eye.
                if (pole == 8) {
                    EXPECT_GT(most, 0.90f) << "azimuth " << azimuth;
                }
            }
}

TEST(Framing, TakesInstancesAndSeveralMeshes)
{
    mesh::Mesh mesh;
    auto& organ = mesh.organs.emplace_back();
    organ.prototype.positions_mm = { Vec3f(-50, 0, 0), Vec3f(50, 0, 0), Vec3f(0, 0, 100) };
    organ.instances = { { .translation_mm = { 3000, 0, 0 } } };
    Framing framing({}, 1);
    framing.add(leaning_poles(8));
    framing.add(mesh);
    auto const place = on_screen(framing.camera(), 1, Vec3(3050, 0, 0));
    EXPECT_NEAR(place.x(), 0.94, 0.01);
}

TEST(Framing, OfNothingIsThatOfAnEmptyBox)
{
    Framing framing({}, 1);
    framing.add(mesh::Mesh());
    EXPECT_TRUE(framing.camera().eye_mm.isApprox(framing_camera(Bounds(), {}, 1).eye_mm));
}

TEST(FramingCamera, TakesAnEmptyBox)
{
    auto const camera = framing_camera(Bounds(), {}, 1);
    EXPECT_TRUE(camera.eye_mm.allFinite());
    EXPECT_GT(camera.distance_mm(), 50);
}

} // namespace tractus::render
