#pragma once

#include <cstdint>

namespace tractus::exports {

// Random functions on the unit square that repeat in both directions, so that pictures made from
// them can be tiled. The same arguments always give the same value.

// Size of the lattice on which a function is built: cells along u and along v, at least 1 each.
struct Lattice {
    int across = 1;
    int along = 1;
};

// Returns smooth noise, 0 to 1, with its mean at one half and features as large as a cell.
// `layer` selects one of 2^32 independent functions.
double tile_noise(double u, double v, Lattice cells, std::uint32_t layer);

// Returns the sum of `octaves` noises, 0 to 1; each is twice as fine as the one before and half as
// strong.
double tile_turbulence(double u, double v, Lattice cells, int octaves, std::uint32_t layer);

// Place of a point among random seeds, one in each cell (Worley 1996). Distances are in cells.
struct TileCell {
    double nearest = 0;     // Distance to the nearest seed.
    double to_border = 0;   // Distance to the border between the two nearest seeds.
    double border_tilt = 0; // Direction of that border: 0 along the axis, 1 around the branch.
    double offset_u = 0;    // From the nearest seed to the point.
    double offset_v = 0;
    double random = 0; // Random number of the nearest seed, 0 to 1.
};

// Returns the place of a point among the seeds. `jitter`: how far seeds stand from the middles of
// their cells, 0 to 1.
TileCell tile_cell(double u, double v, Lattice cells, double jitter, std::uint32_t layer);

// Returns a random number of a lattice cell, 0 to 1. Cells beyond the edges are those of the next
// tile.
double tile_random(int column, int row, Lattice cells, std::uint32_t layer);

} // namespace tractus::exports
