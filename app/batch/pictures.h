#pragma once

#include "app/document/draw.h"
#include "app/render/camera.h"
#include "app/render/image.h"
#include "app/render/offscreen_context.h"
#include "app/render/picture_size.h"
#include "app/render/renderer.h"
#include "app/station/station.h"
#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/scene.h"
#include "engine/stroke/nib.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::batch {

using render::PictureSize;

// Renders pictures for files, without a window. Use it only on the thread that created it.
class PictureMaker {
public:
    // Fails if the system has no OpenGL; the message says what to install.
    static Result<PictureMaker> create();

    // Renders a lit plant on the ground, as seen by `camera`. Without a camera, the plant is fitted
    // into the picture. A shared camera shows all plants of a collection at the same scale.
    render::Image plant(mesh::Mesh const& mesh, PictureSize const& size,
                        std::optional<render::Camera> const& camera = {});

    // Renders the strokes and the base plant's skeleton in the drawing volume. The line width of
    // strokes follows the nib. A branch has the colour of the stroke that shapes it.
    render::Image strokes(scene::Scene const& scene, std::span<document::DrawnStroke const> strokes,
                          Nib nib, PictureSize const& size);

    // Region of a view of a plant for a picture with a transparent background. The plant has its
    // own colours (Stage::Lighting::Colours) and is seen in orthographic projection from a
    // horizontal direction. The region is a square of `side_mm` around `center_mm`, rendered at
    // `side_px` pixels.
    struct Cutout {
        Vec3 center_mm = Vec3::Zero();
        double side_mm = 1000;
        double azimuth_rad = 0; // Direction of the view, as in ViewAngles.
        int side_px = 256;
    };
    std::vector<render::Image> cutouts(mesh::Mesh const& mesh, std::span<Cutout const> views);

private:
    PictureMaker(render::OffscreenContext context, render::Renderer renderer);

    // Declared before the renderer, which must be destroyed first.
    render::OffscreenContext context_;
    render::Renderer renderer_;
};

} // namespace tractus::batch
