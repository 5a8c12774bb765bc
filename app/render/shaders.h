#pragma once

#include <string_view>

// GLSL sources of the renderer, joined into programs by shader.h. Colours in shaders are linear
// light; every fragment shader ends with display(), which converts to screen colours.
namespace tractus::render::shaders {

// Building blocks of the shaders below.
extern std::string_view const kColor; // Conversion between linear light and screen colours.
extern std::string_view const kNoise; // Smooth random noise.
// Vertex shaders: position of an instance's vertex in the plant.
extern std::string_view const kPlacement;
// Fragment shaders: light of sun and sky, and shadow on plants.
extern std::string_view const kSunlight;

// A triangle that covers the screen, without vertex attributes.
extern std::string_view const kFullScreenVertex;

extern std::string_view const kSurfaceVertex; // Surfaces of plants.
extern std::string_view const kSurfaceFragment;

extern std::string_view const kBackdropFragment;
extern std::string_view const kGroundVertex;
extern std::string_view const kGroundFragment;
extern std::string_view const
    kGroundShadeFragment; // Share of the sky that is visible from the ground below a plant.

extern std::string_view const kShadowVertex; // Depth of plants as seen from the sun.
extern std::string_view const kShadowFragment;
extern std::string_view const kGroundShadowFragment;

extern std::string_view const kCurveVertex;
extern std::string_view const kCurveFragment;
extern std::string_view const kCurveShadowFragment;

extern std::string_view const kPictureVertex; // A picture behind everything else.
extern std::string_view const kPictureFragment;

} // namespace tractus::render::shaders
