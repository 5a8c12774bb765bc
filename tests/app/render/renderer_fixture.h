#pragma once

#include "app/render/offscreen_context.h"
#include "app/render/renderer.h"
#include "tests/app/render/small_mesh.h"

#include <gtest/gtest.h>
#include <optional>

namespace tractus::render {

constexpr int kWidth = 400;
constexpr int kHeight = 300;

// Returns a camera on the user's side, slightly above the plant. The sun is on its left.
inline Camera camera()
{
    Camera camera;
    camera.eye_mm = Vec3(0, -1500, 600);
    camera.target_mm = Vec3(0, 0, 130);
    camera.field_of_view_rad = 0.45;
    camera.near_mm = 100;
    camera.far_mm = 20000;
    return camera;
}

// Returns the colour of the pixel that shows a position in the world.
inline Color at(Image const& picture, Vec3 const& world_mm)
{
    double const aspect = static_cast<double>(kWidth) / kHeight;
    Vec3f const place = (projection_matrix(camera(), aspect) * T_camera_world(camera())
                         * world_mm.cast<float>().homogeneous())
                            .hnormalized();
    return picture.at(static_cast<int>((place.x() * 0.5f + 0.5f) * kWidth),
                      static_cast<int>((0.5f - place.y() * 0.5f) * kHeight));
}

inline int brightness(Color const& color)
{
    return color.red + color.green + color.blue;
}

class RendererTest : public testing::Test {
protected:
    void SetUp() override
    {
        auto context = OffscreenContext::create();
        ASSERT_TRUE(context) << context.error().message;
        context_.emplace(std::move(*context));
        auto renderer = Renderer::create();
        ASSERT_TRUE(renderer) << renderer.error().message;
        renderer_.emplace(std::move(*renderer));
    }

    Image picture(Stage const& stage)
    {
        return renderer_->picture(stage, camera(), kWidth, kHeight);
    }

    Image post_picture()
    {
        GpuMesh const mesh(post_with_leaves());
        Stage stage;
        stage.meshes.push_back({ &mesh });
        stage.sun.direction = Vec3f(-1, -0.4f, 1);
        return picture(stage);
    }

    std::optional<OffscreenContext> context_;
    std::optional<Renderer> renderer_;
};

} // namespace tractus::render
