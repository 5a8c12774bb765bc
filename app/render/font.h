#pragma once

#include <cstddef>
#include <span>

namespace tractus::render {

// The program's font, a TrueType file embedded by the build (DejaVu Sans), so that captions and the
// window look the same on every machine.
std::span<std::byte const> font_file();

} // namespace tractus::render
