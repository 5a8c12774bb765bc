#pragma once

#include <cstddef>
#include <span>

namespace tractus::render {

// Returns the program's font: DejaVu Sans, a TrueType file that the build embeds, so that captions
// and the window look the same on every machine.
std::span<std::byte const> font_file();

} // namespace tractus::render
