#include "app/pictures.h"

#include "app/render/camera.h"
#include "app/render/gpu_curves.h"
#include "app/render/gpu_mesh.h"
#include "app/render/stage.h"
#include "app/stroke_curves.h"

#include <utility>

namespace tractus {

namespace {

constexpr float kStrokeWidth_mm = 4;

double aspect(PictureSize const& size)
{
    return static_cast<double>(size.width_px) / size.height_px;
}

} // namespace

PictureMaker::PictureMaker(OffscreenContext context, Renderer renderer)
    : context_(std::move(context))
    , renderer_(std::move(renderer))
{
}

Result<PictureMaker> PictureMaker::create()
{
    auto context = TRY(OffscreenContext::create());
    auto renderer = TRY(Renderer::create());
    return PictureMaker(std::move(context), std::move(renderer));
}

Image PictureMaker::plant(Mesh const& mesh, PictureSize const& size, Bounds const& frame,
                          ViewAngles const& angles)
{
    GpuMesh const gpu_mesh(mesh);
    Stage stage;
    stage.meshes = { { .mesh = &gpu_mesh } };
    auto const camera
        = framing_camera(frame.empty() ? gpu_mesh.bounds() : frame, angles, aspect(size));
    return renderer_.picture(stage, camera, size.width_px, size.height_px);
}

Image PictureMaker::strokes(Scene const& scene, std::span<DrawnStroke const> strokes,
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
            = drawn.tool.kind == Tool::Kind::Draw || drawn.tool.kind == Tool::Kind::DrawInOrder;
        if (shapes && drawn.refusal.empty())
            curves.push_back(
                stroke_curve(drawn.stroke.tips, stroke_color(association++), kStrokeWidth_mm));
    }
    GpuCurves const gpu_curves(curves);
    Stage stage;
    stage.curves = { &gpu_curves };
    ViewAngles const angles { .azimuth_rad = radians(25), .elevation_rad = radians(18) };
    auto const camera = framing_camera(bounds(stage), angles, aspect(size));
    return renderer_.picture(stage, camera, size.width_px, size.height_px);
}

} // namespace tractus
