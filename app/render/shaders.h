#pragma once

#include <string_view>

// GLSL of the renderer, joined into programs by shader.h. Colours inside are linear light; every
// fragment shader ends with display(), which makes screen colours of it.
namespace tractus::render::shaders {

// Pieces that others build on.
extern std::string_view const kColor;     // Linear light to and from screen colours.
extern std::string_view const kNoise;     // Smooth random patterns.
extern std::string_view const kPlacement; // Vertex: where an instance's vertex lies in the plant.
extern std::string_view const kSunlight;  // Fragment: sun and sky, and the shadow on plants.

extern std::string_view const kFullScreenVertex; // A triangle over everything, from no attributes.

extern std::string_view const kSurfaceVertex; // Plants.
extern std::string_view const kSurfaceFragment;

extern std::string_view const kBackdropFragment;
extern std::string_view const kGroundVertex;
extern std::string_view const kGroundFragment;
extern std::string_view const
    kGroundShadeFragment; // Share of the sky that a plant leaves to the ground.

extern std::string_view const kShadowVertex; // The sun's view of plants.
extern std::string_view const kShadowFragment;
extern std::string_view const kGroundShadowFragment;

extern std::string_view const kCurveVertex;
extern std::string_view const kCurveFragment;
extern std::string_view const kCurveShadowFragment;

extern std::string_view const kPictureVertex; // A picture behind all else.
extern std::string_view const kPictureFragment;

} // namespace tractus::render::shaders
