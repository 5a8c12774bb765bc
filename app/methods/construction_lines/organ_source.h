#pragma once

#include "engine/methods/construction_lines/organ_surface.h"

#include <string>

namespace tractus::lines {

// The shape of a sketch's organs as its file states it: the name of another file, or a surface.
struct OrganSource {
    // Path, relative to the sketch, of another sketch or of a leaf drawn in three views (.organ),
    // or the name of a built-in leaf. Empty: `surface` is the shape.
    std::string file {};
    OrganSurface surface {};
};

} // namespace tractus::lines
