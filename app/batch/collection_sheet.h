#pragma once

#include "app/batch/pictures.h"
#include "app/terminal/progress.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <functional>
#include <string>

namespace tractus::batch {

// The plants of a collection that a contact sheet can show. The functions accept indices below
// `count`.
struct SheetPlants {
    std::size_t count = 0;
    std::function<Plant const&(std::size_t)> plant; // The result is valid until the next call.
    std::function<std::string(std::size_t)> caption;
};

// Most plants on a sheet, as many as a screen can show.
constexpr std::size_t kMaxSheetPlants = 48;

// Index of the plant in the `tile`-th picture of a sheet. If there are more than kMaxSheetPlants,
// they are chosen at even intervals from the first to the last.
std::size_t sheet_plant(std::size_t tile, std::size_t count);

// Contact sheet with a small picture of each of these plants, all at the same scale. Keeps one
// plant at a time in memory. Without plants the image is empty.
render::Image collection_sheet(PictureMaker& pictures, SheetPlants const& plants,
                               terminal::Progress& progress);

} // namespace tractus::batch
