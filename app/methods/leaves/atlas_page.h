#pragma once

#include "app/methods/leaves/atlas_channels.h"
#include "engine/export/png.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tractus::leaf {

// Size of an atlas: sides of a leaf's square cell and of a square page in pixels, both powers of
// two, and the number of mipmap levels, at least 1.
struct AtlasSize {
    int cell = 512;
    int page = 2048;
    std::size_t levels = 1;

    std::size_t columns() const { return static_cast<std::size_t>(page / cell); }
};

// A row of cells of a page: the pixels of all maps at all levels. A page is made row by row, since
// all of it would take much memory.
class AtlasRow {
public:
    AtlasRow(AtlasChannels const& channels, AtlasSize const& size);

    // Copies a leaf's picture to a cell of the row, with its smaller levels. Calls for different
    // columns may run on several threads at once.
    void place(leaf::LeafPicture const& picture, std::size_t column);

    // Takes the first pixel of the row, which is not part of a leaf, as the value of empty cells.
    void keep_first_pixel();
    // Fills a cell with that value.
    void leave_empty(std::size_t column);
    // The rows of a map's pixels at a level.
    std::vector<std::uint8_t> const& pixels(std::size_t map, std::size_t level) const
    {
        return pixels_[map * size_.levels + level];
    }

private:
    std::size_t bytes_per_pixel(std::size_t map) const
    {
        return channels_.maps[map].channels.size();
    }
    std::uint8_t* cell_at(std::size_t map, std::size_t level, std::size_t column);
    void place_levels(leaf::LeafPicture const& picture, std::size_t column);

    AtlasChannels const& channels_;
    AtlasSize size_;
    std::vector<std::vector<std::uint8_t>> pixels_; // For each map, its levels.
    std::vector<std::vector<std::uint8_t>> empty_;  // Value of empty cells, likewise.
};

// The .png files of a page, one for each map and level.
class PageFiles {
public:
    PageFiles(AtlasChannels const& channels, AtlasSize const& size);

    // Appends a row of cells to all files. Works on all threads.
    void append(AtlasRow const& row);

    // Completes the files after the last row. For each map, its files from the full size on.
    std::vector<std::vector<std::string>> finish() &&;

private:
    struct File {
        exports::PngStrips strips;
        std::string bytes {};
        std::size_t row_bytes = 0;
        std::vector<std::uint8_t> last_row {};
    };
    std::size_t levels_;
    std::vector<File> files_;
};

} // namespace tractus::leaf
