#pragma once

#include "app/render/gl_objects.h"
#include "app/render/shader.h"
#include "app/render/stage.h"

namespace tractus::render {

// The sun's view: a depth map for shadows on plants, and derived from it a map of how much of the
// ground is in shadow and how distant the occluder is. Coarser levels of the second map blur the
// ground's shadow more the farther its occluder is. Must not outlive the OpenGL context.
class SunShadow {
public:
    // Fails with an internal error if the driver rejects the shaders.
    static Result<SunShadow> create();

    // Renders the stage from the sun into a map of `side` pixels, 64 to 2048. Binds a framebuffer
    // of its own.
    void draw(Stage const& stage, Bounds const& box, int side);

    // Sets a shader's maps (texture units 0 depth, 1 ground) and the transforms for looking up
    // places in them.
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
    float depth_mm_ = 1; // Distance from the near to the far plane.
};

} // namespace tractus::render
