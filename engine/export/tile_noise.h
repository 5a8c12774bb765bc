#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::exports {

// Random functions on the unit square that repeat in both directions, so that pictures made from
// them can be tiled. They may be evaluated from -1 to 2. The same arguments always give the same
// values; `layer` selects one of 2^32 independent functions.

// Size of the lattice on which a function is built: cells along u and along v, at least 1 each.
struct Lattice {
    int across = 1;
    int along = 1;
};

// Returns a random number of a lattice cell, 0 to 1. Cells beyond the edges are those of the next
// tile.
float tile_random(int column, int row, Lattice cells, std::uint32_t layer);

// Smooth noise, 0 to 1, with a mean of one half and features as large as a cell.
class TileNoise {
public:
    TileNoise(Lattice cells, std::uint32_t layer);

    float at(float u, float v) const;

private:
    Lattice cells_;
    std::vector<float> values_; // One for each cell, row by row.
};

// Sum of noises, 0 to 1; each is twice as fine as the one before and half as strong.
class TileTurbulence {
public:
    TileTurbulence(Lattice cells, int octaves, std::uint32_t layer);

    float at(float u, float v) const;
    // From -1 to 1, with a mean of 0.
    float signed_at(float u, float v) const { return 2 * at(u, v) - 1; }

private:
    std::vector<TileNoise> octaves_;
};

// Place of a point among random seeds, one in each cell (Worley 1996). Distances are in cells.
struct TileCell {
    float to_border = 0;   // Distance to the border between the two nearest seeds.
    float border_tilt = 0; // Direction of that border: 0 along the axis, 1 around the branch.
    float offset_u = 0;    // From the nearest seed to the point.
    float offset_v = 0;
    float random = 0; // Random number of the nearest seed, 0 to 1.
};

class TileCells {
public:
    // `jitter`: how far seeds stand from the middles of their cells, 0 to 1.
    TileCells(Lattice cells, float jitter, std::uint32_t layer);

    TileCell at(float u, float v) const;

private:
    // A seed's place in its cell, 0 to 1, and its random number.
    struct Seed {
        float u = 0;
        float v = 0;
        float random = 0;
    };

    Lattice cells_;
    std::vector<Seed> seeds_; // One for each cell, row by row.
};

} // namespace tractus::exports
