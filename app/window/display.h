#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus::window {

// A screen that the window may fill.
struct Display {
    std::string name; // As the system calls it, most often by its maker and model.
    int width_px = 0;
    int height_px = 0;
    Vec2 size_mm = Vec2::Zero(); // Of its picture; 0 where the system does not know.
};

// The one that is a pen tablet's own: as large as the area in which the tablet feels the pen, which
// reaches a little beyond the picture on some, and may be turned. None where none is, or several.
std::optional<std::size_t> tablet_display(std::span<Display const> displays, Vec2 const& area_mm);

// By its number, from 1, or a part of its name in small or capital letters. Fails, as the user's
// fault, naming those that there are, for none or several.
Result<std::size_t> find_display(std::span<Display const> displays, std::string_view which);

} // namespace tractus::window
