#pragma once

#include "app/render/image.h"

#include <string_view>

namespace tractus::render {

// Style of one line of text.
struct TextStyle {
    double size_px = 24; // Text size from the highest ascender to the lowest descender.
    Color color { 40, 42, 46, 255 };
};

// Draws one line of UTF-8 text; the upper left corner of its box is at `corner_px`. Parts outside
// the picture are clipped; characters that the font lacks are drawn as its box.
void draw_text(Image& picture, Vec2 const& corner_px, std::string_view text,
               TextStyle const& style);

// Width of the line that draw_text() would draw, in pixels.
double text_width_px(std::string_view text, TextStyle const& style);

} // namespace tractus::render
