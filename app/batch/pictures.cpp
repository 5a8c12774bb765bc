#include "app/batch/pictures.h"

#include "app/batch/stroke_curves.h"
#include "app/render/camera.h"
#include "app/render/gpu_curves.h"
#include "app/render/gpu_mesh.h"
#include "app/render/stage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tractus::batch {

namespace {

constexpr float kStrokeWidth_mm = 4;

// Cuts out a plant from renderings on black and on white: a pixel is transparent as far as the two
// renderings differ. `ground` is the white background alone, which is darker towards the corners.
render::Image without_ground(render::Image const& on_black, render::Image const& on_white,
                             render::Image const& ground)
{
    render::Image cutout(on_black.width(), on_black.height());
    for (std::size_t i = 0; i < cutout.pixels().size(); ++i) {
        auto const& black = on_black.pixels()[i];
        auto const& white = on_white.pixels()[i];
        auto const& clear = ground.pixels()[i];
        auto const share = [](int bright, int dark, int full) {
            return 255 * std::max(0, bright - dark) / std::max(1, full);
        };
        int const shown = std::max({ share(white.red, black.red, clear.red),
                                     share(white.green, black.green, clear.green),
                                     share(white.blue, black.blue, clear.blue) });
        int const seen = std::max(0, 255 - shown);
        // Undoes the mixture with black: divides a colour of the rendering on black by the opacity.
        auto const full = [&](int part) {
            return static_cast<std::uint8_t>(seen > 0 ? std::min(255, part * 255 / seen) : 0);
        };
        cutout.pixels()[i] = { full(black.red), full(black.green), full(black.blue),
                               static_cast<std::uint8_t>(seen) };
    }
    return cutout;
}

render::Camera camera_for(PictureMaker::Cutout const& view)
{
    Vec3 const towards(std::sin(view.azimuth_rad), -std::cos(view.azimuth_rad), 0);
    return { .eye_mm = view.center_mm + 2 * view.side_mm * towards,
             .target_mm = view.center_mm,
             .projection = render::Camera::Projection::Orthographic,
             .view_height_mm = view.side_mm,
             .near_mm = 0.5 * view.side_mm,
             .far_mm = 3.5 * view.side_mm };
}

} // namespace

PictureMaker::PictureMaker(render::OffscreenContext context, render::Renderer renderer)
    : context_(std::move(context))
    , renderer_(std::move(renderer))
{
}

Result<PictureMaker> PictureMaker::create()
{
    auto context = TRY(render::OffscreenContext::create());
    auto renderer = TRY(render::Renderer::create());
    return PictureMaker(std::move(context), std::move(renderer));
}

render::Image PictureMaker::plant(mesh::Mesh const& mesh, PictureSize const& size,
                                  std::optional<render::Camera> const& camera)
{
    render::GpuMesh const gpu_mesh(mesh);
    render::Stage stage;
    stage.meshes = { { .mesh = &gpu_mesh } };
    render::Framing framing({}, size.aspect());
    if (!camera)
        framing.add(mesh);
    return renderer_.picture(stage, camera.value_or(framing.camera()), size.width_px,
                             size.height_px);
}

std::vector<render::Image> PictureMaker::cutouts(mesh::Mesh const& mesh,
                                                 std::span<Cutout const> views)
{
    render::GpuMesh const gpu_mesh(mesh, render::GpuMesh::Sky::Open);
    render::Stage stage;
    stage.meshes = { { .mesh = &gpu_mesh } };
    stage.backdrop.has_ground = false;
    stage.lighting = render::Stage::Lighting::Colours;
    auto empty = stage;
    empty.meshes.clear();
    std::vector<render::Image> pictures;
    render::Image ground; // White background without a plant, shared by all views of the same size.
    for (auto const& view : views) {
        auto const before = [&](float grey, render::Stage& seen) {
            seen.backdrop.top = seen.backdrop.bottom = Vec3f::Constant(grey);
            return renderer_.picture(seen, camera_for(view), view.side_px, view.side_px);
        };
        if (ground.width() != view.side_px)
            ground = before(1, empty);
        auto const on_black = before(0, stage);
        pictures.push_back(without_ground(on_black, before(1, stage), ground));
    }
    return pictures;
}

render::Image PictureMaker::strokes(scene::Scene const& scene,
                                    std::span<document::DrawnStroke const> strokes, Nib nib,
                                    PictureSize const& size)
{
    auto curves = desk_curves();
    for (auto&& curve : skeleton_curves(scene))
        curves.push_back(std::move(curve));
    for (auto&& curve : indicator_curves(scene))
        curves.push_back(std::move(curve));
    std::size_t association = 0;
    for (auto const& drawn : strokes) {
        bool const shapes
            = std::any_of(drawn.edits.begin(), drawn.edits.end(), [](scene::Edit const& edit) {
                  return edit.get<scene::Associate>() != nullptr;
              });
        if (shapes)
            curves.push_back(
                stroke_curve(drawn.stroke.tips, stroke_color(association++), kStrokeWidth_mm, nib));
    }
    render::GpuCurves const gpu_curves(curves);
    render::Stage stage;
    stage.curves = { &gpu_curves };
    render::ViewAngles const angles { .azimuth_rad = radians(25), .elevation_rad = radians(18) };
    auto const camera = render::framing_camera(render::bounds(stage), angles, size.aspect());
    return renderer_.picture(stage, camera, size.width_px, size.height_px);
}

} // namespace tractus::batch
