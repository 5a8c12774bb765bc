#pragma once

#include "app/render/gl_objects.h"
#include "app/render/shader.h"
#include "app/render/stage.h"

namespace tractus::render {

// View of the sun: a depth map for the shadows on plants, and made from it a map of how much of the
// ground is hidden and from how far, whose coarser levels give the ground's shadow a blur that
// grows with the distance to what casts it. Lives and dies with the context.
class SunShadow {
public:
    // Fails, as the station's fault, if the driver does not take the shaders.
    static Result<SunShadow> create();

    // Draws the stage from the sun with a map of `side` pixels, 64 to 2048. Binds a framebuffer of
    // its own.
    void draw(Stage const& stage, Bounds const& box, int side);

    // Gives a shader the maps (texture units 0 depth, 1 ground) and how to look places up in them.
    void apply(Shader const& shader) const;

private:
    SunShadow(Shader depth, Shader curves, Shader ground);

    void resize(int side);
    void draw_depth(Stage const& stage);
    void draw_ground(Stage const& stage);

    Shader depth_shader_;
    Shader curve_shader_;
    Shader ground_shader_;
    gl::Texture depth_;
    gl::Texture ground_;
    gl::Framebuffer depth_target_;
    gl::Framebuffer ground_target_;
    gl::VertexArray no_vertices_;
    int side_ = 0;
    Eigen::Matrix4f T_clip_world_ = Eigen::Matrix4f::Identity();
    Vec3f sun_ = Vec3f::UnitZ();
    float texel_mm_ = 1;
    float depth_mm_ = 1; // Depth from the near to the far plane.
};

} // namespace tractus::render
