#pragma once

#include "engine/methods/construction_lines/organ_surface.h"

#include <string>

namespace tractus::lines {

// Shape of a sketch's leaves as stated in its file: another file, or a surface.
struct OrganSource {
    // Another sketch or a leaf in three views (.organ), as a path relative to the sketch, or the
    // name of a built-in leaf. Empty: use `surface`.
    std::string file {};
    OrganSurface surface {};
};

} // namespace tractus::lines
