#include "engine/export/bark_style.h"

#include <algorithm>
#include <cmath>

namespace tractus::exports {

namespace {

// Numbers of the independent random functions.
enum Layer : std::uint32_t {
    kBlotches = 1,
    kGrain = 11,
    kWrinkles = 21,
    kFlakes = 31,
    kFlakeBend = 41,
    kLenticels = 51,
    kRidges = 61,
    kWander = 71,
    kFurrowWidth = 81,
    kCracks = 91,
    kRidgeShade = 1001,
    kClefts = 1011,
    kCleftBend = 1021,
    kPatches = 1031,
    kPatchBend = 1041,
};

double eased_step(double low, double high, double x)
{
    double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Vec3 mixed(Vec3 const& a, Vec3 const& b, double t)
{
    return a + t * (b - a);
}

// Noise with a mean of 0, -1 to 1.
double signed_noise(double u, double v, Lattice cells, int octaves, std::uint32_t layer)
{
    return 2 * tile_turbulence(u, v, cells, octaves, layer) - 1;
}

class PointMaker {
public:
    PointMaker(BarkStyle const& style, double u, double v)
        : style_(style)
        , u_(u)
        , v_(v)
    {
    }

    BarkPoint run()
    {
        add_surface();
        if (style_.patches.share > 0)
            add_patches();
        if (style_.flakes.height > 0)
            add_flakes();
        if (style_.furrows.width > 0)
            add_furrows();
        if (style_.lenticels.share > 0)
            add_lenticels();
        if (style_.clefts.share > 0)
            add_clefts();
        point_.height = std::clamp(point_.height, 0.0, 1.0);
        point_.color = point_.color.cwiseMax(0).cwiseMin(1);
        return point_;
    }

private:
    void add_surface()
    {
        auto const& surface = style_.surface;
        double const blotch
            = eased_step(0.38, 0.62, tile_turbulence(u_, v_, { 4, 3 }, 4, kBlotches));
        double const grain = signed_noise(u_, v_, { 40, 40 }, 3, kGrain);
        double const lines = signed_noise(u_, v_, { 5, 90 }, 2, kWrinkles);
        point_.color = mixed(surface.color, surface.other_color, blotch)
            * (1 + surface.grain * grain + surface.wrinkles * lines);
        point_.height = 0.6 + 0.12 * grain * surface.grain / 0.05 + surface.wrinkles * lines;
        point_.roughness = surface.roughness;
    }

    // The older a piece, the darker and higher it is.
    void add_patches()
    {
        auto const& patches = style_.patches;
        double const bend_u = 0.5 * signed_noise(u_, v_, { 9, 8 }, 3, kPatchBend) / 9;
        double const bend_v = 0.5 * signed_noise(u_, v_, { 9, 8 }, 3, kPatchBend + 5) / 8;
        auto const cell = tile_cell(u_ + bend_u, v_ + bend_v, patches.cells, 0.95, kPatches);
        if (cell.random >= patches.share)
            return;
        double const freshness = 1 - cell.random / patches.share;
        point_.color = mixed(point_.color, patches.fresh, 0.35 + 0.65 * freshness);
        point_.height -= (0.15 + 0.3 * freshness) * eased_step(0, 0.05, cell.to_border);
    }

    void add_flakes()
    {
        auto const& flakes = style_.flakes;
        double const bend = 0.6 * signed_noise(u_, v_, { 14, 12 }, 3, kFlakeBend);
        auto const cell = tile_cell(u_ + bend / flakes.cells.across, v_ + bend / flakes.cells.along,
                                    flakes.cells, 0.9, kFlakes);
        // A flake is lifted at its lower edge.
        double const lift = 0.5 - 0.6 * cell.offset_v;
        double const edge = 1 - eased_step(0.01, 0.07, cell.to_border);
        point_.height += flakes.height * (0.5 * lift + 0.4 * (cell.random - 0.5) - 0.5 * edge);
        point_.color *= 1 + flakes.change * (2 * cell.random - 1);
        point_.color = mixed(point_.color, flakes.edge, 0.75 * edge);
    }

    void add_furrows()
    {
        auto const& furrows = style_.furrows;
        Lattice const bends { std::max(furrows.ridges.across / 2, 1),
                              std::max(furrows.ridges.along, 1) };
        double const wander = furrows.wander / furrows.ridges.across;
        double const u = u_ + wander * signed_noise(u_, v_, bends, 4, kWander);
        auto const cell = tile_cell(u, v_, furrows.ridges, 0.95, kRidges);
        double const across = std::pow(cell.border_tilt, 2) * furrows.bridges;
        double const varied = 0.65 + 0.7 * tile_noise(u_, v_, furrows.ridges, kFurrowWidth);
        double const width = furrows.width * varied;
        // The border's distance is in cells, which are longer than wide.
        double const depth
            = (1 - eased_step(0.15 * width, width, cell.to_border)) * (1 - 0.92 * across);
        double crack = 0;
        if (furrows.crack_depth > 0) {
            auto const piece
                = tile_cell(u + 0.4 * wander * signed_noise(u_, v_, furrows.cracks, 2, kCracks + 7),
                            v_, furrows.cracks, 0.9, kCracks);
            crack
                = furrows.crack_depth * (1 - eased_step(0.02, 0.16, piece.to_border)) * (1 - depth);
            point_.color *= 1 + 0.10 * (2 * piece.random - 1);
            point_.height += 0.10 * (piece.random - 0.5);
        }
        double const rounded = 0.3 * eased_step(0, 2.5 * width, cell.to_border);
        point_.height = (0.62 * point_.height + 0.13 + rounded) * (1 - depth) - 0.5 * crack;
        point_.color *= 1 + 0.10 * (2 * tile_noise(u_, v_, furrows.ridges, kRidgeShade) - 1);
        point_.color = mixed(point_.color, furrows.color, std::min(1.0, 0.95 * depth + crack));
        point_.roughness = std::max(point_.roughness, 0.9 * depth);
    }

    void add_lenticels()
    {
        auto const& pores = style_.lenticels;
        auto const column = static_cast<int>(std::floor(u_ * pores.cells.across));
        auto const row = static_cast<int>(std::floor(v_ * pores.cells.along));
        // Long ones reach into the neighbouring cells.
        for (int i = -1; i <= 1; ++i) {
            auto const random = [&](std::uint32_t which) {
                return tile_random(column + i, row, pores.cells, kLenticels + which);
            };
            if (random(0) >= pores.share)
                continue;
            double const half = 0.5 * pores.length * (0.4 + 1.6 * random(1) * random(1));
            double const du
                = (u_ * pores.cells.across - (column + i + 0.2 + 0.6 * random(2))) / half;
            double const thickness = pores.thickness * (0.6 + 0.8 * random(3));
            double const dv = (v_ * pores.cells.along - (row + 0.3 + 0.4 * random(4))) / thickness;
            double const inside = 1 - eased_step(0.5, 1, du * du * du * du + dv * dv);
            point_.color = mixed(point_.color, pores.color, 0.85 * inside);
            point_.height += pores.height * inside;
        }
    }

    void add_clefts()
    {
        auto const& clefts = style_.clefts;
        auto const cell = tile_cell(u_, v_, clefts.cells, 0.45, kClefts);
        if (cell.random >= clefts.share)
            return;
        double const size = clefts.size * (0.45 + 0.55 * cell.random / clefts.share);
        double const ragged = 0.35 * signed_noise(u_, v_, { 30, 12 }, 3, kCleftBend);
        // The cells' borders bound the rhombus.
        double const near_border = 1 - eased_step(0, 0.1, cell.to_border);
        double const from_middle = std::abs(cell.offset_u) / size
            + std::abs(cell.offset_v) / (1.15 * size) + ragged + near_border;
        double const inside = 1 - eased_step(0.78, 1.0, from_middle);
        double const rough = tile_turbulence(u_, v_, { 60, 14 }, 3, kCleftBend + 9);
        Vec3 const color = clefts.color * (0.6 + 1.1 * rough);
        point_.color = mixed(point_.color, color, inside);
        point_.height += inside * (rough - 0.75);
        point_.roughness += inside * (0.95 - point_.roughness);
    }

    BarkStyle const& style_;
    double u_;
    double v_;
    BarkPoint point_;
};

} // namespace

BarkPoint bark_point(BarkStyle const& style, double u, double v)
{
    return PointMaker(style, u, v).run();
}

} // namespace tractus::exports
