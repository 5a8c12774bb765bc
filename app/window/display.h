#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus::window {

// A display that the window may fill.
struct Display {
    std::string name; // The system's name of the display, usually maker and model.
    int width_px = 0;
    int height_px = 0;
    // Size of the display's picture area; 0 if the system does not know it.
    Vec2 size_mm = Vec2::Zero();
};

// Finds the built-in display of a pen tablet: the one as large as the tablet's active area, which
// may be a little larger than the picture and rotated by 90°. nullopt if none fits, or several.
std::optional<std::size_t> tablet_display(std::span<Display const> displays, Vec2 const& area_mm);

// Finds a display by its number, from 1, or by part of its name, ignoring case. Fails with a user
// error and a list of the displays if none or several match.
Result<std::size_t> find_display(std::span<Display const> displays, std::string_view which);

} // namespace tractus::window
