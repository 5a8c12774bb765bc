#pragma once

#include "app/render/gpu_curves.h"
#include "app/render/gpu_mesh.h"
#include "app/render/gpu_picture.h"

#include <limits>
#include <optional>
#include <vector>

namespace tractus::render {

// A mesh and where it stands. T_world_plant may turn, move and scale evenly.
struct StagedMesh {
    GpuMesh const* mesh = nullptr; // Owned elsewhere; alive while drawn.
    Eigen::Affine3f T_world_plant = Eigen::Affine3f::Identity();
};

// A picture behind all else, and where it lies: its upper left corner, and its edges from there.
struct StagedPicture {
    GpuPicture const* picture = nullptr; // Owned elsewhere; alive while drawn.
    Vec3f corner_mm = Vec3f::Zero();
    Vec3f right_mm = Vec3f::UnitX();
    Vec3f down_mm = -Vec3f::UnitY();
    float strength = 1; // 0 to 1: how much of it covers the backdrop.
};

// The sun: light that casts the shadow.
struct Sun {
    Vec3f direction { -0.62f, -0.28f, 0.73f }; // Towards it; any length. World frame.
    float strength = 1;                        // Factor on its light; at least 0.
};

// Background, and the ground, which fades into it. Colours are sRGB, 0 to 1.
struct Backdrop {
    Vec3f top { 0.83f, 0.87f, 0.90f };
    Vec3f bottom { 0.95f, 0.94f, 0.92f };
    Vec3f ground { 0.80f, 0.77f, 0.72f };
    bool has_ground = true; // Ground at z = 0, with shadows on it; see shows_ground().
};

// Dark surroundings for pictures inside a dark window.
Backdrop dark_backdrop();

// Everything that stands before the camera. World frame, millimetres.
struct Stage {
    std::vector<StagedMesh> meshes;
    std::vector<GpuCurves const*> curves; // Owned elsewhere; alive while drawn.
    std::optional<StagedPicture> picture {};
    Sun sun;
    Backdrop backdrop;
    // Colours: each surface in its own colour, without light, shade and gloss, for pictures that
    // others will light.
    enum class Lighting { Lit, Colours };
    Lighting lighting = Lighting::Lit;
    // Curves are cut off above this height.
    double hidden_above_mm = std::numeric_limits<double>::infinity();
    bool curves_cast_shadows = true;
    // Fading of curves' colours: between `from_mm` and `range_mm` below it they go towards another
    // one, by `share` at the most.
    struct Fade {
        Vec3f color = Vec3f::Zero();
        float share = 0;
        float from_mm = 0; // A height.
        float range_mm = 1;
    };
    Fade fade;
};

// Whether the ground is drawn: not where it would hide roots or a valley's plants, as it is opaque.
// Meshes that reach below it by over a tenth of their height are taken for such.
bool shows_ground(Stage const& stage);

// The box around all meshes and curves. Empty for an empty stage.
Bounds bounds(Stage const& stage);

} // namespace tractus::render
