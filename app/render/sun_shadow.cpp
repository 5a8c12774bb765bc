#include "app/render/sun_shadow.h"

#include "app/render/camera.h"
#include "app/render/shaders.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::render {

namespace {

// Coarsest mipmap level of the ground map; still coarser ones would be only a few pixels wide.
constexpr int kGroundLevels = 8;

void set_filter(GLenum minifying, GLenum magnifying)
{
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minifying));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnifying));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
}

} // namespace

Result<SunShadow> SunShadow::create()
{
    auto depth = TRY(Shader::build({ "shadow",
                                     { shaders::kPlacement, shaders::kShadowVertex },
                                     { shaders::kShadowFragment } }));
    auto curves = TRY(Shader::build(
        { "curve shadow", { shaders::kCurveVertex }, { shaders::kCurveShadowFragment } }));
    auto ground = TRY(Shader::build(
        { "ground shadow", { shaders::kFullScreenVertex }, { shaders::kGroundShadowFragment } }));
    return SunShadow(std::move(depth), std::move(curves), std::move(ground));
}

SunShadow::SunShadow(Shader depth, Shader curves, Shader ground)
    : depth_shader_(std::move(depth))
    , curve_shader_(std::move(curves))
    , ground_shader_(std::move(ground))
{
}

void SunShadow::resize(int side)
{
    if (side == side_)
        return;
    side_ = side;
    constexpr std::array<float, 4> kFarthest { 1, 1, 1, 1 };
    glBindTexture(GL_TEXTURE_2D, depth_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    set_filter(GL_LINEAR, GL_LINEAR);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kFarthest.data());
    glBindFramebuffer(GL_FRAMEBUFFER, depth_target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);

    glBindTexture(GL_TEXTURE_2D, ground_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, side / 2, side / 2, 0, GL_RG, GL_FLOAT, nullptr);
    set_filter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, kGroundLevels);
    glBindFramebuffer(GL_FRAMEBUFFER, ground_target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, ground_.name(), 0);
    CHECK(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void SunShadow::draw(Stage const& stage, Bounds const& box, int side, SurfacePictures& pictures)
{
    CHECK(side >= 64 && side <= 2048);
    resize(side);
    // Orthographic view of the bounding sphere of the whole stage.
    Vec3 const center = (box.min_mm + box.max_mm) / 2;
    double const radius_mm = std::max(1.0, (box.max_mm - box.min_mm).norm() / 2 * 1.03);
    sun_ = stage.sun.direction.normalized();
    Camera eye;
    eye.projection = Camera::Projection::Orthographic;
    eye.eye_mm = center + sun_.cast<double>() * radius_mm * 2;
    eye.target_mm = center;
    eye.up = std::abs(sun_.z()) > 0.99f ? Vec3::UnitY() : Vec3::UnitZ();
    eye.view_height_mm = 2 * radius_mm;
    eye.near_mm = radius_mm * 0.9;
    eye.far_mm = radius_mm * 3.1;
    T_clip_world_ = projection_matrix(eye, 1) * T_camera_world(eye);
    texel_mm_ = static_cast<float>(eye.view_height_mm / side);
    depth_mm_ = static_cast<float>(eye.far_mm - eye.near_mm);
    draw_depth(stage, pictures);
    draw_ground(stage);
}

void SunShadow::draw_depth(Stage const& stage, SurfacePictures& pictures)
{
    glBindFramebuffer(GL_FRAMEBUFFER, depth_target_.name());
    glViewport(0, 0, side_, side_);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glClear(GL_DEPTH_BUFFER_BIT);
    depth_shader_.use();
    for (auto const& placed : stage.meshes) {
        depth_shader_.set("T_clip_plant",
                          Eigen::Matrix4f(T_clip_world_ * placed.T_world_plant.matrix()));
        float const scale = placed.T_world_plant.linear().col(0).norm();
        for (auto const& part : placed.mesh->parts())
            placed.mesh->draw(part, depth_shader_, pictures, texel_mm_ / scale);
    }
    if (!stage.curves_cast_shadows)
        return;
    curve_shader_.use();
    curve_shader_.set("T_clip_world", T_clip_world_);
    curve_shader_.set("viewport_px", Vec2f(static_cast<float>(side_), static_cast<float>(side_)));
    curve_shader_.set("pixels_per_mm", 1 / texel_mm_);
    curve_shader_.set("hidden_above_mm", static_cast<float>(stage.hidden_above_mm));
    for (auto const* curves : stage.curves)
        curves->draw();
}

void SunShadow::draw_ground(Stage const& stage)
{
    if (!shows_ground(stage))
        return;
    glBindFramebuffer(GL_FRAMEBUFFER, ground_target_.name());
    glViewport(0, 0, side_ / 2, side_ / 2);
    glDisable(GL_DEPTH_TEST);
    ground_shader_.use();
    apply(ground_shader_);
    // The shader compares depths itself, so the texture unit must return the depths as they are.
    glActiveTexture(GL_TEXTURE0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    ground_shader_.set("T_world_clip", Eigen::Matrix4f(T_clip_world_.inverse()));
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, ground_.name());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void SunShadow::apply(Shader const& shader) const
{
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, depth_.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, ground_.name());
    shader.set("sun_depth", 0);
    shader.set("sun_ground", 1);
    shader.set("T_sun_world", T_clip_world_);
    shader.set("sun_direction", sun_);
    shader.set("sun_texel_mm", texel_mm_);
    shader.set("sun_depth_mm", depth_mm_);
    shader.set("sun_map_side", static_cast<float>(side_));
}

} // namespace tractus::render
