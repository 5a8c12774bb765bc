#pragma once

#include <string_view>

// GLSL sources of the renderer; shader.h joins them into programs. Colours in shaders are linear
// light. Every fragment shader ends with display(), which converts its result to screen colours.
namespace tractus::render::shaders {

// Functions that several shaders include.
extern std::string_view const kColor; // Conversion between linear light and screen colours.
extern std::string_view const kNoise; // Smooth random noise.
// For vertex shaders: position of an instance's vertex in the plant.
extern std::string_view const kPlacement;
// For fragment shaders: light of the sun and sky, and the shadow on plants.
extern std::string_view const kSunlight;

// Vertex shader of a triangle that covers the screen; it has no vertex attributes.
extern std::string_view const kFullScreenVertex;

extern std::string_view const kSurfaceVertex; // Vertex shader for surfaces of plants.
extern std::string_view const kSurfaceFragment;

extern std::string_view const kBackdropFragment;
extern std::string_view const kGroundVertex;
extern std::string_view const kGroundFragment;
// Fragment shader for the share of the sky that is visible from the ground below a plant.
extern std::string_view const kGroundShadeFragment;

// Vertex shader for the depth of plants as seen from the sun.
extern std::string_view const kShadowVertex;
extern std::string_view const kShadowFragment;
extern std::string_view const kGroundShadowFragment;

extern std::string_view const kCurveVertex;
extern std::string_view const kCurveFragment;
extern std::string_view const kCurveShadowFragment;

extern std::string_view const kPictureVertex; // Vertex shader for a picture behind everything else.
extern std::string_view const kPictureFragment;

} // namespace tractus::render::shaders
