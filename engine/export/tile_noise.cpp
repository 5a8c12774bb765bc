#include "engine/export/tile_noise.h"

#include <algorithm>
#include <cmath>

namespace tractus::exports {

namespace {

// Mixes the bits of a lattice point's number (a multiply-xorshift hash).
std::uint32_t mixed_bits(std::uint32_t column, std::uint32_t row, std::uint32_t layer)
{
    std::uint32_t bits = column * 0x9E3779B1U ^ row * 0x85EBCA77U ^ layer * 0xC2B2AE3DU;
    bits ^= bits >> 15;
    bits *= 0x2C1B3C6DU;
    bits ^= bits >> 12;
    bits *= 0x297A2D39U;
    bits ^= bits >> 15;
    return bits;
}

int wrapped_cell(int cell, int count)
{
    int const rest = cell % count;
    return rest < 0 ? rest + count : rest;
}

double smooth_step(double t)
{
    return t * t * (3 - 2 * t);
}

} // namespace

double tile_random(int column, int row, Lattice cells, std::uint32_t layer)
{
    return mixed_bits(static_cast<std::uint32_t>(wrapped_cell(column, cells.across)),
                      static_cast<std::uint32_t>(wrapped_cell(row, cells.along)), layer)
        * 0x1p-32;
}

double tile_noise(double u, double v, Lattice cells, std::uint32_t layer)
{
    double const x = u * cells.across;
    double const y = v * cells.along;
    auto const column = static_cast<int>(std::floor(x));
    auto const row = static_cast<int>(std::floor(y));
    double const across = smooth_step(x - column);
    double const along = smooth_step(y - row);
    auto const value = [&](int i, int j) { return tile_random(column + i, row + j, cells, layer); };
    double const lower = value(0, 0) + across * (value(1, 0) - value(0, 0));
    double const upper = value(0, 1) + across * (value(1, 1) - value(0, 1));
    return lower + along * (upper - lower);
}

double tile_turbulence(double u, double v, Lattice cells, int octaves, std::uint32_t layer)
{
    double sum = 0;
    double weight = 1;
    double weights = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * tile_noise(u, v, cells, layer + 101 * static_cast<std::uint32_t>(i));
        weights += weight;
        weight *= 0.5;
        cells.across *= 2;
        cells.along *= 2;
    }
    return sum / weights;
}

TileCell tile_cell(double u, double v, Lattice cells, double jitter, std::uint32_t layer)
{
    double const x = u * cells.across;
    double const y = v * cells.along;
    auto const column = static_cast<int>(std::floor(x));
    auto const row = static_cast<int>(std::floor(y));
    struct Seed {
        double u = 0, v = 0, squared = 1e9, random = 0;
    };
    Seed first;
    Seed second;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            auto const random_of = [&](std::uint32_t which) {
                return tile_random(column + i, row + j, cells, layer + which);
            };
            Seed seed;
            seed.u = x - (column + i + 0.5 + jitter * (random_of(0) - 0.5));
            seed.v = y - (row + j + 0.5 + jitter * (random_of(1) - 0.5));
            seed.squared = seed.u * seed.u + seed.v * seed.v;
            if (seed.squared >= second.squared)
                continue;
            seed.random = random_of(2);
            second = seed;
            if (second.squared < first.squared)
                std::swap(first, second);
        }
    double const between_u = first.u - second.u;
    double const between_v = first.v - second.v;
    double const between = std::max(std::hypot(between_u, between_v), 1e-9);
    return { .nearest = std::sqrt(first.squared),
             .to_border = (second.squared - first.squared) / (2 * between),
             .border_tilt = std::abs(between_v) / between,
             .offset_u = first.u,
             .offset_v = first.v,
             .random = first.random };
}

} // namespace tractus::exports
