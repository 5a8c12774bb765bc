#pragma once

#include "app/batch/pictures.h"
#include "app/terminal/progress.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <functional>
#include <string>

namespace tractus::batch {

// The plants of a collection that a sheet shows. All functions take a number below `count`.
struct SheetPlants {
    std::size_t count = 0;
    std::function<Plant const&(std::size_t)> plant; // Holds until the next call.
    std::function<std::string(std::size_t)> caption;
};

// How many plants a sheet shows at most: what a screen shows at once.
constexpr std::size_t kMostSheetPlants = 48;

// Returns which plant the `tile`-th picture of a sheet shows: all of them, or kMostSheetPlants from
// the first to the last, evenly apart.
std::size_t sheet_plant(std::size_t tile, std::size_t count);

// A small picture of each of these plants, all at one scale. Memory holds the pictures and one
// plant. No plants give an empty picture.
render::Image collection_sheet(PictureMaker& pictures, SheetPlants const& plants,
                               terminal::Progress& progress);

} // namespace tractus::batch
