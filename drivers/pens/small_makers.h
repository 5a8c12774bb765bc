#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// Report formats that few known tablets use: "genius" and "waltop" (Genius, Trust and Waltop),
// "lifetec", "robotpen", "woodpad" (ViewSonic), "floogoo".
std::span<PenFamily const> small_makers_families();

} // namespace tractus::drivers
