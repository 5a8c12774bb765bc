#include "app/methods/leaves/atlas_page.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"

#include <algorithm>
#include <utility>

namespace tractus::leaf {

namespace {

std::size_t side_at(int side, std::size_t level)
{
    return static_cast<std::size_t>(side) >> level;
}

} // namespace

AtlasRow::AtlasRow(AtlasChannels const& channels, AtlasSize const& size)
    : channels_(channels)
    , size_(size)
{
    for (std::size_t map = 0; map < channels.maps.size(); ++map)
        for (std::size_t level = 0; level < size.levels; ++level)
            pixels_.emplace_back(side_at(size.page, level) * side_at(size.cell, level)
                                 * bytes_per_pixel(map));
}

std::uint8_t* AtlasRow::cell_at(std::size_t map, std::size_t level, std::size_t column)
{
    return pixels_[map * size_.levels + level].data()
        + column * side_at(size_.cell, level) * bytes_per_pixel(map);
}

void AtlasRow::place(leaf::LeafPicture const& picture, std::size_t column)
{
    CHECK(picture.side == size_.cell);
    for (std::size_t map = 0; map < channels_.maps.size(); ++map)
        place_picture(channels_.maps[map], picture, cell_at(map, 0, column),
                      side_at(size_.page, 0) * bytes_per_pixel(map));
    if (size_.levels > 1)
        place_levels(picture, column);
}

void AtlasRow::place_levels(leaf::LeafPicture const& picture, std::size_t column)
{
    std::vector<std::uint8_t> alphas;
    alphas.reserve(picture.color.size());
    for (auto const& pixel : picture.color)
        alphas.push_back(pixel[3]);
    AlphaMips const alpha(alphas, size_.cell, size_.cell,
                          static_cast<int>(side_at(size_.cell, size_.levels - 1)));
    for (std::size_t map = 0; map < channels_.maps.size(); ++map) {
        auto const channels = bytes_per_pixel(map);
        PixelMap whole { .width = size_.cell,
                         .height = size_.cell,
                         .channels = static_cast<int>(channels) };
        whole.pixels.resize(side_at(size_.cell, 0) * side_at(size_.cell, 0) * channels);
        place_picture(channels_.maps[map], picture, whole.pixels.data(),
                      side_at(size_.cell, 0) * channels);
        auto const levels = mip_levels(whole, channels_.maps[map].kind, alpha);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            auto const bytes = side_at(size_.cell, i + 1) * channels;
            auto* to = cell_at(map, i + 1, column);
            for (auto from = levels[i].pixels.begin(); from != levels[i].pixels.end();
                 from += static_cast<std::ptrdiff_t>(bytes)) {
                std::copy_n(from, bytes, to);
                to += side_at(size_.page, i + 1) * channels;
            }
        }
    }
}

void AtlasRow::keep_first_pixel()
{
    empty_.clear();
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        empty_.emplace_back(pixels_[i].begin(),
                            pixels_[i].begin()
                                + static_cast<std::ptrdiff_t>(bytes_per_pixel(i / size_.levels)));
}

void AtlasRow::leave_empty(std::size_t column)
{
    CHECK(!empty_.empty());
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        auto const map = i / size_.levels;
        auto const level = i % size_.levels;
        auto const cell = side_at(size_.cell, level);
        auto* row = cell_at(map, level, column);
        for (std::size_t y = 0; y < cell; ++y) {
            auto* to = row;
            for (std::size_t x = 0; x < cell; ++x)
                to = std::ranges::copy(empty_[i], to).out;
            row += side_at(size_.page, level) * bytes_per_pixel(map);
        }
    }
}

PageFiles::PageFiles(AtlasChannels const& channels, AtlasSize const& size)
    : levels_(size.levels)
{
    for (auto const& map : channels.maps)
        for (std::size_t level = 0; level < levels_; ++level) {
            auto const side = static_cast<int>(side_at(size.page, level));
            files_.push_back({ .strips = { side, side, static_cast<int>(map.channels.size()) },
                               .row_bytes = side_at(size.page, level) * map.channels.size() });
            files_.back().bytes = files_.back().strips.header();
        }
}

void PageFiles::append(AtlasRow const& row)
{
    parallel_for(files_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto& file = files_[i];
            auto const& pixels = row.pixels(i / levels_, i % levels_);
            file.strips.append(file.strips.pack(pixels, file.last_row), file.bytes);
            file.last_row.assign(pixels.end() - static_cast<std::ptrdiff_t>(file.row_bytes),
                                 pixels.end());
        }
    });
}

std::vector<std::vector<std::string>> PageFiles::finish() &&
{
    std::vector<std::vector<std::string>> made(files_.size() / levels_);
    for (std::size_t i = 0; i < files_.size(); ++i) {
        files_[i].bytes += files_[i].strips.end();
        made[i / levels_].push_back(std::move(files_[i].bytes));
    }
    return made;
}

} // namespace tractus::leaf
