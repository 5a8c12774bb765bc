#pragma once

#include "engine/base/vectors.h"

namespace tractus::theme {

// Colours that people with any kind of colour vision tell apart (Okabe and Ito 2008, "Color
// universal design"), sRGB, 0 to 1, on a dark ground.
inline Vec3f const kInk { 0.96f, 0.80f, 0.38f };
inline Vec3f const kStroke { 0.90f, 0.62f, 0.00f };
inline Vec3f const kIndicator { 0.84f, 0.37f, 0.00f };
inline Vec3f const kUnselected { 0.62f, 0.65f, 0.68f };
inline Vec3f const kUndetermined { 0.94f, 0.89f, 0.26f };
inline Vec3f const kSelected { 0.34f, 0.71f, 0.91f };
inline Vec3f const kAssigned { 0.00f, 0.62f, 0.45f };
inline Vec3f const kGrid { 0.27f, 0.30f, 0.33f };
inline Vec3f const kVolume { 0.22f, 0.245f, 0.27f };
inline Vec3f const kPadBackground { 0.095f, 0.105f, 0.12f };
inline Vec3f const kFaint { 0.21f, 0.235f, 0.26f };

} // namespace tractus::theme
