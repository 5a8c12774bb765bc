#pragma once

#include "engine/methods/construction_lines/organ_surface.h"

#include <string>

namespace tractus::lines {

// What stands in the leaves' place, as a sketch's file says it.
struct OrganSource {
    std::string sketch {};   // The name of another sketch's file, from where this one is. Empty:
    OrganSurface surface {}; // a surface.
};

} // namespace tractus::lines
