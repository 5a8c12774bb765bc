#include "engine/methods/leaves/paint_spread.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace tractus::leaf {

namespace {

// Sums for weighted means of colour, occlusion, roughness, translucency and underside colour. The
// weight is the coverage of a pixel by the leaf.
struct Mean {
    std::array<float, 9> sum {};
    float weight = 0;

    void add(Mean const& other)
    {
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += other.sum[i];
        weight += other.weight;
    }
    std::uint8_t value(std::size_t i) const
    {
        return weight > 0 ? static_cast<std::uint8_t>(sum[i] / weight + 0.5f) : std::uint8_t { 0 };
    }
};

class Spreader {
public:
    Spreader(LeafPicture& picture, TileGrid const& tiles)
        : picture_(picture)
        , tiles_(tiles)
        , has_underside_(!picture.under_color.empty())
    {
    }

    void spread()
    {
        sum_up();
        for (int row = 0; row < tiles_.columns(); ++row)
            for (int column = 0; column < tiles_.columns(); ++column)
                if (!tiles_.is_near(column, row))
                    fill(column, row, nearest(column, row));
    }

private:
    // Calls work(index of the first pixel, number of pixels) for each row of pixels of a tile,
    // without pixels outside the picture.
    template<typename Work> void for_rows(int column, int row, Work const& work) const
    {
        constexpr int kWidth = TileGrid::kTile;
        int const end = std::min(picture_.side, (row + 1) * kWidth);
        int const count = std::min(kWidth, picture_.side - column * kWidth);
        for (int y = row * kWidth; y < end; ++y)
            work(static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.side)
                     + static_cast<std::size_t>(column * kWidth),
                 static_cast<std::size_t>(count));
    }

    Mean mean_of(int column, int row) const
    {
        // Step between sampled rows and columns of pixels: a mean does not need all pixels.
        constexpr std::size_t kEach = 4;
        Mean mean;
        std::size_t y = 0;
        for_rows(column, row, [&](std::size_t at, std::size_t count) {
            if (y++ % kEach != 0)
                return;
            for (std::size_t i = at; i < at + count; i += kEach) {
                float const weight = picture_.coverage[i] + 1e-3f;
                auto const& color = picture_.color[i];
                auto const& rough = picture_.roughness[i];
                auto const under
                    = has_underside_ ? picture_.under_color[i] : std::array<std::uint8_t, 3> {};
                std::array<std::uint8_t, 9> const values {
                    color[0], color[1], color[2], rough[0], rough[1], picture_.translucency[i],
                    under[0], under[1], under[2]
                };
                for (std::size_t c = 0; c < values.size(); ++c)
                    mean.sum[c] += weight * static_cast<float>(values[c]);
                mean.weight += weight;
            }
        });
        return mean;
    }

    void sum_up()
    {
        int size = tiles_.columns();
        std::vector<Mean> level;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column)
                level.push_back(tiles_.is_near(column, row) ? mean_of(column, row) : Mean {});
        levels_ = { level };
        while (size > 1) {
            int const half = (size + 1) / 2;
            std::vector<Mean> coarse(static_cast<std::size_t>(half * half));
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column)
                    coarse[static_cast<std::size_t>(row / 2 * half + column / 2)].add(
                        levels_.back()[static_cast<std::size_t>(row * size + column)]);
            levels_.push_back(std::move(coarse));
            size = half;
        }
    }

    Mean nearest(int column, int row) const
    {
        int size = tiles_.columns();
        for (auto const& level : levels_) {
            auto const& mean = level[static_cast<std::size_t>(row * size + column)];
            if (mean.weight > 0)
                return mean;
            size = (size + 1) / 2;
            row /= 2;
            column /= 2;
        }
        return {};
    }

    void fill(int column, int row, Mean const& mean)
    {
        std::array<std::uint8_t, 4> const color { mean.value(0), mean.value(1), mean.value(2), 0 };
        std::array<std::uint8_t, 3> const flat { 128, 128, 255 };
        std::array<std::uint8_t, 3> const rough { mean.value(3), mean.value(4), 0 };
        for_rows(column, row, [&](std::size_t at, std::size_t count) {
            auto const first = static_cast<std::ptrdiff_t>(at);
            std::fill_n(picture_.color.begin() + first, count, color);
            std::fill_n(picture_.normal.begin() + first, count, flat);
            std::fill_n(picture_.roughness.begin() + first, count, rough);
            std::fill_n(picture_.translucency.begin() + first, count, mean.value(5));
            if (!has_underside_)
                return;
            std::array<std::uint8_t, 3> const under { mean.value(6), mean.value(7), mean.value(8) };
            std::fill_n(picture_.under_color.begin() + first, count, under);
            std::fill_n(picture_.under_normal.begin() + first, count, flat);
        });
    }

    LeafPicture& picture_;
    TileGrid const& tiles_;
    bool has_underside_;
    // For each level, the means over squares of 1, 2, 4 ... tiles on a side.
    std::vector<std::vector<Mean>> levels_;
};

} // namespace

void spread_colors(LeafPicture& picture, TileGrid const& tiles)
{
    Spreader(picture, tiles).spread();
}

} // namespace tractus::leaf
