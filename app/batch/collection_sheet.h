#pragma once

#include "app/batch/pictures.h"
#include "app/terminal/progress.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <functional>
#include <string>

namespace tractus::batch {

// The plants of a collection that a contact sheet can show. The functions accept indices from 0 to
// `count` - 1.
struct SheetPlants {
    std::size_t count = 0;
    std::function<Plant const&(std::size_t)> plant; // The result is valid until the next call.
    std::function<std::string(std::size_t)> caption;
};

// Maximum number of plants on a sheet; a screen cannot show more.
constexpr std::size_t kMaxSheetPlants = 48;

// Returns the index of the plant in the sheet's picture number `tile`, counted from 0. If there are
// more than kMaxSheetPlants plants, the sheet shows evenly spaced ones, from the first to the last.
std::size_t sheet_plant(std::size_t tile, std::size_t count);

// Renders a contact sheet with a small picture, of the size `tile_size`, of each of the plants, all
// at the same scale. Keeps one plant at a time in memory. Without plants the image is empty.
render::Image collection_sheet(PictureMaker& pictures, SheetPlants const& plants,
                               PictureSize const& tile_size, terminal::Progress& progress);

// Default size of a small picture on a sheet.
constexpr PictureSize kSheetTile { 240, 240 };

} // namespace tractus::batch
