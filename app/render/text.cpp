#include "app/render/text.h"

#include "app/render/font.h"
#include "engine/base/check.h"

#include <cmath>
#include <stb_truetype.h>
#include <vector>

namespace tractus::render {

namespace {

// Removes the first character of a UTF-8 text (RFC 3629) and returns its code point. Malformed
// bytes become U+FFFD.
int next_code_point(std::string_view& text)
{
    auto const lead = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    if (lead < 0x80)
        return lead;
    int const following = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
    if (following == 0 || text.size() < static_cast<std::size_t>(following))
        return 0xfffd;
    int code_point = lead & (0x3f >> following);
    for (int i = 0; i < following; ++i) {
        code_point = code_point << 6 | (static_cast<unsigned char>(text.front()) & 0x3f);
        text.remove_prefix(1);
    }
    return code_point;
}

stbtt_fontinfo const& font()
{
    static auto const info = [] {
        stbtt_fontinfo result {};
        auto const* const bytes = reinterpret_cast<unsigned char const*>(font_file().data());
        CHECK(stbtt_InitFont(&result, bytes, 0) != 0);
        return result;
    }();
    return info;
}

void blend(Color& pixel, Color const& over, int coverage)
{
    auto const mix = [share = coverage * over.alpha](std::uint8_t below, std::uint8_t above) {
        return static_cast<std::uint8_t>(
            (below * (255 * 255 - share) + above * share + 255 * 255 / 2) / (255 * 255));
    };
    pixel = { mix(pixel.red, over.red), mix(pixel.green, over.green), mix(pixel.blue, over.blue),
              pixel.alpha };
}

struct GizmoPlace {
    int glyph = 0;
    double x_px = 0; // Distance of the glyph's origin from the line's left end.
};

// Positions of a line's glyphs, with kerning, and the line's width.
struct Line {
    std::vector<GizmoPlace> glyphs;
    double width_px = 0;
};

Line set_line(std::string_view text, float scale)
{
    Line line;
    int previous = 0;
    while (!text.empty()) {
        int const glyph = stbtt_FindGlyphIndex(&font(), next_code_point(text));
        int advance = 0;
        int bearing = 0;
        stbtt_GetGlyphHMetrics(&font(), glyph, &advance, &bearing);
        if (!line.glyphs.empty())
            line.width_px
                += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&font(), previous, glyph));
        line.glyphs.push_back({ glyph, line.width_px });
        line.width_px += scale * static_cast<float>(advance);
        previous = glyph;
    }
    return line;
}

void draw_glyph(Image& picture, int glyph, Vec2 const& origin_px, float scale, Color const& color)
{
    double const whole_x = std::floor(origin_px.x());
    auto const shift_x = static_cast<float>(origin_px.x() - whole_x);
    int left = 0, top = 0, right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font(), glyph, scale, scale, shift_x, 0, &left, &top, &right,
                                    &bottom);
    int const width = right - left;
    int const height = bottom - top;
    if (width <= 0 || height <= 0)
        return;
    std::vector<unsigned char> coverage(static_cast<std::size_t>(width)
                                        * static_cast<std::size_t>(height));
    stbtt_MakeGlyphBitmapSubpixel(&font(), coverage.data(), width, height, width, scale, scale,
                                  shift_x, 0, glyph);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            int const x = static_cast<int>(whole_x) + left + column;
            int const y = static_cast<int>(std::lround(origin_px.y())) + top + row;
            if (x >= 0 && y >= 0 && x < picture.width() && y < picture.height())
                blend(picture.at(x, y), color,
                      coverage[static_cast<std::size_t>(row * width + column)]);
        }
    }
}

} // namespace

void draw_text(Image& picture, Vec2 const& corner_px, std::string_view text, TextStyle const& style)
{
    float const scale = stbtt_ScaleForPixelHeight(&font(), static_cast<float>(style.size_px));
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&font(), &ascent, &descent, &gap);
    for (auto const& place : set_line(text, scale).glyphs)
        draw_glyph(picture, place.glyph,
                   corner_px + Vec2(place.x_px, scale * static_cast<float>(ascent)), scale,
                   style.color);
}

double text_width_px(std::string_view text, TextStyle const& style)
{
    return set_line(text, stbtt_ScaleForPixelHeight(&font(), static_cast<float>(style.size_px)))
        .width_px;
}

} // namespace tractus::render
