#pragma once

#include "app/document/draw.h"
#include "app/render/camera.h"
#include "app/render/image.h"
#include "app/render/offscreen_context.h"
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

struct PictureSize {
    int width_px = 1280;
    int height_px = 960;

    double aspect() const { return static_cast<double>(width_px) / height_px; }
};

// Makes the pictures that go into files, without a window, on the thread that created it.
class PictureMaker {
public:
    // Fails where the system has no OpenGL; the message says what to install.
    static Result<PictureMaker> create();

    // A plant, lit, on the ground, all of it in the picture or as `camera` sees it: so plants of
    // one collection are shown alike.
    render::Image plant(mesh::Mesh const& mesh, PictureSize const& size,
                        std::optional<render::Camera> const& camera = {});

    // The strokes in the drawing volume with the base plant's skeleton: what a stroke shapes has
    // the stroke's colour, and its ink is as the nib leaves it.
    render::Image strokes(scene::Scene const& scene, std::span<document::DrawnStroke const> strokes,
                          Nib nib, PictureSize const& size);

    // A plant's own colours (Stage::Lighting::Colours) as it is seen from the horizontal direction,
    // without perspective: `side_mm` around `center_mm`, as a square of `side_px`. What is no plant
    // is transparent.
    struct Cutout {
        Vec3 center_mm = Vec3::Zero();
        double side_mm = 1000;
        double azimuth_rad = 0; // As in ViewAngles.
        int side_px = 256;
    };
    std::vector<render::Image> cutouts(mesh::Mesh const& mesh, std::span<Cutout const> views);

private:
    PictureMaker(render::OffscreenContext context, render::Renderer renderer);

    render::OffscreenContext context_; // Before the renderer, which must go first.
    render::Renderer renderer_;
};

} // namespace tractus::batch
