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
    std::string name; // The system's name for the display, usually its maker and model.
    int width_px = 0;
    int height_px = 0;
    // Size of the display's visible area; 0 if the system does not know it.
    Vec2 size_mm = Vec2::Zero();
};

// Finds the display that is built into a pen tablet: the only one as large as the tablet's active
// area. That area may be a little larger than the display, and rotated by 90°. nullopt if no
// display fits, or several do.
std::optional<std::size_t> tablet_display(std::span<Display const> displays, Vec2 const& area_mm);

// Finds a display by its number, counted from 1, or by part of its name, ignoring case. Fails with
// a user error that lists the displays if none or several match.
Result<std::size_t> find_display(std::span<Display const> displays, std::string_view which);

} // namespace tractus::window
