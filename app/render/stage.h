#pragma once

#include "app/render/gpu_curves.h"
#include "app/render/gpu_mesh.h"
#include "app/render/gpu_picture.h"

#include <limits>
#include <optional>
#include <vector>

namespace tractus::render {

// A mesh and its placement. T_world_plant may contain a rotation, a translation and a uniform
// scale.
struct StagedMesh {
    GpuMesh const* mesh = nullptr; // Not owned; must outlive the drawing.
    Eigen::Affine3f T_world_plant = Eigen::Affine3f::Identity();
};

// A picture behind everything else. It is placed by its upper left corner and its two edges.
struct StagedPicture {
    GpuPicture const* picture = nullptr; // Not owned; must outlive the drawing.
    Vec3f corner_mm = Vec3f::Zero();
    Vec3f right_mm = Vec3f::UnitX();
    Vec3f down_mm = -Vec3f::UnitY();
    float strength = 1; // Opacity of the picture in front of the backdrop, 0 to 1.
};

// Sunlight. It casts shadows.
struct Sun {
    // Direction towards the sun, of any length. World frame.
    Vec3f direction { -0.62f, -0.28f, 0.73f };
    float strength = 1; // Factor on the sun's intensity; at least 0.
};

// Colours of the background, and of the ground, which fades into the background. sRGB, 0 to 1.
struct Backdrop {
    Vec3f top { 0.83f, 0.87f, 0.90f };
    Vec3f bottom { 0.95f, 0.94f, 0.92f };
    Vec3f ground { 0.80f, 0.77f, 0.72f };
    // True: the ground is drawn at z = 0, with shadows on it. See also shows_ground().
    bool has_ground = true;
};

// Dark backdrop for pictures inside a dark window.
Backdrop dark_backdrop();

// Everything that a picture shows. World frame, millimetres.
struct Stage {
    std::vector<StagedMesh> meshes;
    std::vector<GpuCurves const*> curves; // Not owned; must outlive the drawing.
    std::optional<StagedPicture> picture {};
    Sun sun;
    Backdrop backdrop;
    // Colours shows every surface in its own colour, without light, shadow and gloss. This is for
    // pictures that other programs will light.
    enum class Lighting { Lit, Colours };
    Lighting lighting = Lighting::Lit;
    // Parts of curves above this height are not drawn.
    double hidden_above_mm = std::numeric_limits<double>::infinity();
    bool curves_cast_shadows = true;
    // Fading of curves with depth. From the height `from_mm` downwards, over a range of `range_mm`,
    // the curves' colour blends into `color`, up to the share `share`.
    struct Fade {
        Vec3f color = Vec3f::Zero();
        float share = 0;
        float from_mm = 0; // Height below which curves fade.
        float range_mm = 1;
    };
    Fade fade;
};

// True if the opaque ground is drawn. It is left out if it would hide roots or the plants of a
// valley. This is assumed if meshes reach below the ground by more than a tenth of their height.
bool shows_ground(Stage const& stage);

// Bounding box of all meshes and curves. Empty for an empty stage.
Bounds bounds(Stage const& stage);

} // namespace tractus::render
