#pragma once

#include "app/render/image.h"

#include <span>
#include <string>

namespace tractus::render {

// One picture of a contact sheet. All tiles of a sheet must have the same size.
struct SheetTile {
    Image picture;
    std::string caption; // One line of UTF-8 below the picture; may be empty.
};

struct SheetStyle {
    int columns = 4; // Number of columns, at least 1.
    int gap_px = 18; // Gap between tiles and around the sheet.
    double caption_size_px = 22;
    double title_size_px = 34;
    std::string title; // Printed above the tiles; empty: no space is reserved.
    Color paper { 246, 245, 242, 255 };
    Color ink { 52, 54, 58, 255 };
};

// Position of a tile's picture on its sheet.
struct TilePlace {
    int x = 0;
    int y = 0;
};
TilePlace tile_place(int tile, Image const& first_picture, SheetStyle const& style);

// Arranges the tiles in rows of `columns`, with centred captions below; the last row may be
// shorter. Without tiles the image is empty.
Image contact_sheet(std::span<SheetTile const> tiles, SheetStyle const& style = {});

} // namespace tractus::render
