#pragma once

#include "app/render/image.h"

#include <span>
#include <string>

namespace tractus::render {

// A picture of a contact sheet, with its caption. All tiles of a sheet must have the same size.
struct SheetTile {
    Image picture;
    std::string caption; // One line of UTF-8 below the picture; may be empty.
};

struct SheetStyle {
    int columns = 4; // Number of columns, at least 1.
    int gap_px = 18; // Gap between tiles, and between the tiles and the edge of the sheet.
    double caption_size_px = 22;
    double title_size_px = 34;
    std::string title; // Text above the tiles; empty: no space is reserved for it.
    Color paper { 246, 245, 242, 255 };
    Color ink { 52, 54, 58, 255 };
};

// Position of the upper left corner of a tile's picture on its sheet, in pixels.
struct TilePlace {
    int x = 0;
    int y = 0;
};
TilePlace tile_place(int tile, Image const& first_picture, SheetStyle const& style);

// Draws a sheet of tiles in rows of `style.columns` tiles, with centred captions below the
// pictures. The last row may be shorter. Without tiles the image is empty.
Image contact_sheet(std::span<SheetTile const> tiles, SheetStyle const& style = {});

} // namespace tractus::render
