#include "app/render/renderer.h"

#include "app/render/shader.h"
#include "app/render/shaders.h"
#include "app/render/sun_shadow.h"

#include <algorithm>
#include <cmath>

namespace tractus::render {

namespace {

Result<Shader> surface_shader(std::string_view name, std::string_view kind)
{
    return Shader::build({ name,
                           { shaders::kPlacement, shaders::kSurfaceVertex },
                           { kind, shaders::kColor, shaders::kNoise, shaders::kSunlight,
                             shaders::kSurfaceFragment } });
}

// Returns the side of the shadow map: about two of its pixels for each pixel of the picture.
int shadow_map_side(Canvas const& canvas)
{
    int const longest = std::max(canvas.width(), canvas.height());
    return longest > 700 ? 2048 : longest > 350 ? 1024 : 512;
}

} // namespace

struct Renderer::Parts {
    Shader bark;
    Shader thin;
    Shader plain;
    Shader backdrop;
    Shader ground;
    Shader ground_shade;
    Shader curve;
    Shader picture;
    SunShadow shadow;
    SurfacePictures pictures {};
    gl::VertexArray no_vertices {};

    // State of one picture, shared by its rendering passes.
    struct View {
        Stage const& stage;
        Camera const& camera;
        Canvas const& canvas;
        Bounds box {};
        Eigen::Matrix4f T_clip_world = Eigen::Matrix4f::Identity();
        float pixels_per_mm = 1;           // Scale of the picture where the clip coordinate w is 1.
        Vec2f depth_terms = Vec2f::Zero(); // Elements (2, 2) and (2, 3) of the projection matrix.
    };

    void draw_backdrop(View const& view) const;
    void draw_picture(View const& view) const;
    void draw_ground(View const& view) const;
    void draw_ground_shade(View const& view) const;
    void draw_meshes(View const& view);
    void draw_curves(View const& view) const;

    Shader const& shader_for(Material const& material) const;
};

Renderer::Renderer(std::unique_ptr<Parts> parts)
    : parts_(std::move(parts))
{
}

Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create()
{
    using namespace shaders;
    auto bark = TRY(surface_shader("bark", "#define BARK\n"));
    auto thin = TRY(surface_shader("leaf", "#define THIN\n"));
    auto plain = TRY(surface_shader("plain", "#define PLAIN\n"));
    auto backdrop
        = TRY(Shader::build({ "backdrop", { kFullScreenVertex }, { kBackdropFragment } }));
    auto ground = TRY(Shader::build(
        { "ground", { kGroundVertex }, { kColor, kNoise, kSunlight, kGroundFragment } }));
    auto shade
        = TRY(Shader::build({ "ground shade", { kGroundVertex }, { kGroundShadeFragment } }));
    auto curve = TRY(Shader::build({ "curve", { kCurveVertex }, { kCurveFragment } }));
    auto picture = TRY(Shader::build({ "picture", { kPictureVertex }, { kPictureFragment } }));
    auto shadow = TRY(SunShadow::create());
    return Renderer(std::make_unique<Parts>(Parts { .bark = std::move(bark),
                                                    .thin = std::move(thin),
                                                    .plain = std::move(plain),
                                                    .backdrop = std::move(backdrop),
                                                    .ground = std::move(ground),
                                                    .ground_shade = std::move(shade),
                                                    .curve = std::move(curve),
                                                    .picture = std::move(picture),
                                                    .shadow = std::move(shadow) }));
}

void Renderer::draw(Stage const& stage, Camera const& camera, Canvas const& canvas)
{
    double const aspect = static_cast<double>(canvas.width()) / canvas.height();
    auto const projection = projection_matrix(camera, aspect);
    Parts::View view { stage, camera, canvas };
    view.box = bounds(stage);
    if (view.box.empty())
        view.box.add(Vec3::Zero());
    view.T_clip_world = projection * T_camera_world(camera);
    view.pixels_per_mm = projection(1, 1) * static_cast<float>(canvas.height()) / 2;
    view.depth_terms = Vec2f(projection(2, 2), projection(2, 3));

    parts_->pictures.drop_unused();
    bool const is_lit = stage.lighting == Stage::Lighting::Lit;
    bool const has_ground = shows_ground(stage);
    if (has_ground || (is_lit && !stage.meshes.empty()))
        parts_->shadow.draw(stage, view.box, shadow_map_side(canvas), parts_->pictures);
    canvas.bind();
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    parts_->draw_backdrop(view);
    // Passes after the backdrop use alpha as coverage. Alpha is not written, so that the picture
    // stays opaque.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    if (stage.picture)
        parts_->draw_picture(view);
    if (has_ground) {
        parts_->draw_ground(view);
        parts_->draw_ground_shade(view);
    }
    parts_->draw_meshes(view);
    parts_->draw_curves(view);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    canvas.resolve();
}

Image Renderer::picture(Stage const& stage, Camera const& camera, int width, int height)
{
    Canvas const canvas(width, height);
    draw(stage, camera, canvas);
    return canvas.image();
}

void Renderer::Parts::draw_backdrop(View const& view) const
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    backdrop.use();
    backdrop.set("top", view.stage.backdrop.top);
    backdrop.set("bottom", view.stage.backdrop.bottom);
    backdrop.set("aspect",
                 static_cast<float>(view.canvas.width())
                     / static_cast<float>(view.canvas.height()));
    glBindVertexArray(no_vertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}

void Renderer::Parts::draw_picture(View const& view) const
{
    auto const& staged = *view.stage.picture;
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_DEPTH_TEST);
    picture.use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, staged.picture->texture());
    picture.set("picture", 0);
    picture.set("T_clip_world", view.T_clip_world);
    picture.set("corner", staged.corner_mm);
    picture.set("right", staged.right_mm);
    picture.set("down", staged.down_mm);
    picture.set("strength", staged.strength);
    glBindVertexArray(no_vertices.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

void Renderer::Parts::draw_ground(View const& view) const
{
    Vec3f const extent = (view.box.max_mm - view.box.min_mm).cast<float>();
    Vec3f const center = ((view.box.max_mm + view.box.min_mm) / 2).cast<float>();
    float const radius_mm
        = std::max(2.2f * extent.norm(), 1.5f * static_cast<float>(view.camera.distance_mm()));
    ground.use();
    shadow.apply(ground);
    ground.set("T_clip_world", view.T_clip_world);
    ground.set("T_world_plant", Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
    ground.set("corner", Vec2f(center.head<2>() - Vec2f::Constant(radius_mm)));
    ground.set("size", Vec2f(Vec2f::Constant(2 * radius_mm)));
    ground.set("ground_color", linear_light(view.stage.backdrop.ground));
    ground.set("grain_mm", radius_mm * 0.012f);
    ground.set("sun_strength", view.stage.sun.strength);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthFunc(GL_ALWAYS);
    glBindVertexArray(no_vertices.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_BLEND);
}

void Renderer::Parts::draw_ground_shade(View const& view) const
{
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    ground_shade.use();
    ground_shade.set("T_clip_world", view.T_clip_world);
    ground_shade.set("sky_seen", 0);
    glBindVertexArray(no_vertices.name());
    for (auto const& placed : view.stage.meshes) {
        glBindTexture(GL_TEXTURE_2D, placed.mesh->ground_texture());
        ground_shade.set("T_world_plant", placed.T_world_plant.matrix());
        ground_shade.set("corner", placed.mesh->ground_corner_mm());
        ground_shade.set("size", placed.mesh->ground_size_mm());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

Shader const& Renderer::Parts::shader_for(Material const& material) const
{
    switch (material.kind) {
    case Material::Kind::Bark:
        return bark;
    case Material::Kind::Leaf:
    case Material::Kind::Petal:
        return thin;
    case Material::Kind::Stem:
    case Material::Kind::Solid:
        return plain;
    }
    return plain;
}

void Renderer::Parts::draw_meshes(View const& view)
{
    for (auto const* shader : { &bark, &thin, &plain }) {
        shader->use();
        shadow.apply(*shader);
        shader->set("T_clip_world", view.T_clip_world);
        shader->set("eye", Vec3f(view.camera.eye_mm.cast<float>()));
        shader->set("sun_strength", view.stage.sun.strength);
        shader->set("is_lit", view.stage.lighting == Stage::Lighting::Lit ? 1.0f : 0.0f);
    }
    // Width of a pixel at the camera's target. Organs at other distances are drawn with the same
    // triangles.
    bool const is_perspective = view.camera.projection == Camera::Projection::Perspective;
    float const pixel_mm = (is_perspective ? static_cast<float>(view.camera.distance_mm()) : 1.0f)
        / view.pixels_per_mm;
    // Smooths the edges of pictures that are masked by alpha.
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    for (auto const& placed : view.stage.meshes) {
        float const scale = placed.T_world_plant.linear().col(0).norm();
        for (auto const& part : placed.mesh->parts()) {
            auto const& material = part.material;
            auto const& shader = shader_for(material);
            shader.use();
            shader.set("T_world_plant", placed.T_world_plant.matrix());
            shader.set("roughness", material.roughness);
            shader.set("metalness", material.metalness);
            shader.set("translucency", material.translucency);
            shader.set("veins", material.kind == Material::Kind::Leaf ? 1.0f : 0.0f);
            // Veins drawn by the shader need texture coordinates in the unit square. Leaves with
            // pictures do not have such coordinates.
            shader.set("drawn_veins", material.textures.base_color ? 0.0f : 1.0f);
            placed.mesh->draw(part, shader, pictures, pixel_mm / scale);
        }
    }
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

void Renderer::Parts::draw_curves(View const& view) const
{
    if (view.stage.curves.empty())
        return;
    // Coverage by alpha smooths the curves' edges, while every sample keeps a depth of its own.
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    curve.use();
    curve.set("T_clip_world", view.T_clip_world);
    curve.set(
        "viewport_px",
        Vec2f(static_cast<float>(view.canvas.width()), static_cast<float>(view.canvas.height())));
    curve.set("pixels_per_mm", view.pixels_per_mm);
    curve.set("depth_terms", view.depth_terms);
    curve.set("hidden_above_mm", static_cast<float>(view.stage.hidden_above_mm));
    auto const& fade = view.stage.fade;
    curve.set("fade_color", fade.color);
    curve.set("fade_terms", Vec3f(fade.share, fade.from_mm, 1 / fade.range_mm));
    for (auto const* curves : view.stage.curves)
        curves->draw();
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

} // namespace tractus::render
