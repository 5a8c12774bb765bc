#pragma once

#include "engine/methods/construction_lines/organ_surface.h"

#include <string>

namespace tractus::lines {

// What stands in the leaves' place, as a sketch's file says it: another file, or a surface.
struct OrganSource {
    // The name of a file, from where the sketch's is: another sketch's, or that of a leaf in three
    // views (.organ); or the name of one of our leaves. Empty: a surface.
    std::string file {};
    OrganSurface surface {};
};

} // namespace tractus::lines
