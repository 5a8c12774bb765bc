#pragma once

#include "app/render/gl_objects.h"
#include "app/render/shader.h"
#include "app/render/stage.h"
#include "app/render/surface_picture.h"

namespace tractus::render {

// The stage as seen from the sun. A depth map gives the shadows on plants. From it, a second map is
// made of how much of the ground is in shadow and how far away the occluder is. With a more distant
// occluder, a coarser level of the second map is used, so that the ground's shadow is more blurred.
// Must not outlive the OpenGL context.
class SunShadow {
public:
    // Fails with an internal error if the driver rejects the shaders.
    static Result<SunShadow> create();

    // Renders the stage as seen from the sun, into a map of `side` pixels, 64 to 2048. Uploads
    // pictures that are not there yet. Leaves one of its own framebuffers bound.
    void draw(Stage const& stage, Bounds const& box, int side, SurfacePictures& pictures);

    // Sets a shader's maps (texture unit 0: depth, 1: ground), and the transforms from a place to
    // its coordinates in the maps.
    void apply(Shader const& shader) const;

private:
    SunShadow(Shader depth, Shader curves, Shader ground);

    void resize(int side);
    void draw_depth(Stage const& stage, SurfacePictures& pictures);
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
