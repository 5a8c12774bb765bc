#pragma once

#include "app/render/gpu_curves.h"
#include "app/render/gpu_mesh.h"
#include "app/render/gpu_picture.h"

#include <limits>
#include <optional>
#include <vector>

namespace tractus::render {

// A mesh and its placement. T_world_plant may rotate, translate and scale uniformly.
struct StagedMesh {
    GpuMesh const* mesh = nullptr; // Not owned; must outlive the drawing.
    Eigen::Affine3f T_world_plant = Eigen::Affine3f::Identity();
};

// A picture behind everything else, placed by its upper left corner and its edges.
struct StagedPicture {
    GpuPicture const* picture = nullptr; // Not owned; must outlive the drawing.
    Vec3f corner_mm = Vec3f::Zero();
    Vec3f right_mm = Vec3f::UnitX();
    Vec3f down_mm = -Vec3f::UnitY();
    float strength = 1; // Opacity in front of the backdrop, 0 to 1.
};

// Sunlight, which casts the shadow.
struct Sun {
    // Direction towards the sun, of any length. World frame.
    Vec3f direction { -0.62f, -0.28f, 0.73f };
    float strength = 1; // Factor of the sun's intensity; at least 0.
};

// Background, and the ground, which fades into it. Colours are sRGB, 0 to 1.
struct Backdrop {
    Vec3f top { 0.83f, 0.87f, 0.90f };
    Vec3f bottom { 0.95f, 0.94f, 0.92f };
    Vec3f ground { 0.80f, 0.77f, 0.72f };
    bool has_ground = true; // Draws the ground at z = 0 with shadows on it; see shows_ground().
};

// Dark backdrop for pictures inside a dark window.
Backdrop dark_backdrop();

// Everything to be drawn. World frame, millimetres.
struct Stage {
    std::vector<StagedMesh> meshes;
    std::vector<GpuCurves const*> curves; // Not owned; must outlive the drawing.
    std::optional<StagedPicture> picture {};
    Sun sun;
    Backdrop backdrop;
    // Colours shows every surface in its own colour, without light, shadow and gloss, for pictures
    // that other programs will light.
    enum class Lighting { Lit, Colours };
    Lighting lighting = Lighting::Lit;
    // Curves are clipped above this height.
    double hidden_above_mm = std::numeric_limits<double>::infinity();
    bool curves_cast_shadows = true;
    // Fading of curves with depth: below `from_mm`, over a range of `range_mm`, their colour blends
    // into another one, by at most `share`.
    struct Fade {
        Vec3f color = Vec3f::Zero();
        float share = 0;
        float from_mm = 0; // Height at which fading starts.
        float range_mm = 1;
    };
    Fade fade;
};

// Whether the opaque ground is drawn. It is left out if it would hide roots or the plants of a
// valley, which is assumed for meshes that reach below it by more than a tenth of their height.
bool shows_ground(Stage const& stage);

// Bounding box of all meshes and curves. Empty for an empty stage.
Bounds bounds(Stage const& stage);

} // namespace tractus::render
