#include "app/render/contact_sheet.h"

#include "app/render/text.h"
#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::render {

namespace {

int caption_room_px(SheetStyle const& style)
{
    return static_cast<int>(std::lround(style.caption_size_px * 1.5));
}

int title_room_px(SheetStyle const& style)
{
    return style.title.empty() ? 0 : static_cast<int>(std::lround(style.title_size_px * 1.5));
}

void draw_caption(Image& sheet, SheetTile const& tile, TilePlace const& place,
                  SheetStyle const& style)
{
    TextStyle const text { style.caption_size_px, style.ink };
    double const slack_px = tile.picture.width() - text_width_px(tile.caption, text);
    Vec2 const corner(place.x + slack_px / 2,
                      place.y + tile.picture.height() + style.caption_size_px * 0.25);
    draw_text(sheet, corner, tile.caption, text);
}

} // namespace

TilePlace tile_place(int tile, Image const& first_picture, SheetStyle const& style)
{
    int const row_px = first_picture.height() + caption_room_px(style) + style.gap_px;
    int const column_px = first_picture.width() + style.gap_px;
    return { style.gap_px + tile % style.columns * column_px,
             style.gap_px + title_room_px(style) + tile / style.columns * row_px };
}

Image contact_sheet(std::span<SheetTile const> tiles, SheetStyle const& style)
{
    CHECK(style.columns > 0);
    if (tiles.empty())
        return {};
    auto const& first = tiles.front().picture;
    int const count = static_cast<int>(tiles.size());
    int const columns = std::min(count, style.columns);
    auto const right = tile_place(columns - 1, first, style);
    auto const bottom = tile_place(count - 1, first, style);
    Image sheet(right.x + first.width() + style.gap_px,
                bottom.y + first.height() + caption_room_px(style) + style.gap_px, style.paper);

    draw_text(sheet, Vec2(style.gap_px, style.gap_px * 0.8), style.title,
              { style.title_size_px, style.ink });
    for (int i = 0; i < count; ++i) {
        auto const& tile = tiles[static_cast<std::size_t>(i)];
        CHECK(tile.picture.width() == first.width() && tile.picture.height() == first.height());
        auto const place = tile_place(i, first, style);
        paste(sheet, tile.picture, place.x, place.y);
        draw_caption(sheet, tile, place, style);
    }
    return sheet;
}

} // namespace tractus::render
