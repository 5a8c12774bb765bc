#pragma once

#include "app/render/image.h"

#include <string_view>

namespace tractus::render {

// Style of one line of text.
struct TextStyle {
    double size_px = 24; // Height of the line, from the highest ascender to the lowest descender.
    Color color { 40, 42, 46, 255 };
};

// Draws one line of UTF-8 text. `corner_px` is the upper left corner of the line's box. Parts
// outside the picture are clipped; characters that the font lacks are drawn as an empty box.
void draw_text(Image& picture, Vec2 const& corner_px, std::string_view text,
               TextStyle const& style);

// Returns the width, in pixels, of the line that draw_text() would draw.
double text_width_px(std::string_view text, TextStyle const& style);

} // namespace tractus::render
