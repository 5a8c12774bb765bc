#pragma once

#include "app/render/image.h"

#include <string_view>

namespace tractus::render {

// How one line of text is set.
struct TextStyle {
    double size_px = 24; // Size from the highest ascender to the lowest descender.
    Color color { 40, 42, 46, 255 };
};

// Draws one line of UTF-8 text whose box has its upper left corner at (x, y). What lies outside the
// picture is left out; characters that the font lacks show as its box.
void draw_text(Image& picture, Vec2 const& corner_px, std::string_view text,
               TextStyle const& style);

// Width of the line that draw_text() would draw, in pixels.
double text_width_px(std::string_view text, TextStyle const& style);

} // namespace tractus::render
