#include "engine/export/bark_style.h"

#include <algorithm>
#include <cmath>

namespace tractus::exports {

namespace {

// Numbers of the independent random functions.
constexpr std::uint32_t kBlotches = 1;
constexpr std::uint32_t kGrain = 11;
constexpr std::uint32_t kWrinkles = 21;
constexpr std::uint32_t kFlakes = 31;
constexpr std::uint32_t kFlakeBend = 41;
constexpr std::uint32_t kLenticels = 51;
constexpr std::uint32_t kRidges = 61;
constexpr std::uint32_t kWander = 71;
constexpr std::uint32_t kFurrowWidth = 81;
constexpr std::uint32_t kCracks = 91;
constexpr std::uint32_t kCrackWander = 98;
constexpr std::uint32_t kRidgeShade = 1001;
constexpr std::uint32_t kClefts = 1011;
constexpr std::uint32_t kCleftEdge = 1021;
constexpr std::uint32_t kCleftBottom = 1030;
constexpr std::uint32_t kPatches = 1031;
constexpr std::uint32_t kPatchBendU = 1041;
constexpr std::uint32_t kPatchBendV = 1046;

float eased_step(float low, float high, float x)
{
    float const t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

Vec3f mixed(Vec3f const& a, Vec3f const& b, float t)
{
    return a + t * (b - a);
}

} // namespace

BarkField::BarkField(BarkStyle const& style)
    : style_(style)
    , surface_ { TileTurbulence({ 4, 3 }, 4, kBlotches), TileTurbulence({ 40, 40 }, 3, kGrain),
                 TileTurbulence({ 5, 90 }, 2, kWrinkles) }
{
    if (auto const& furrows = style.furrows; furrows.width > 0) {
        Lattice const bends { std::max(furrows.ridges.across / 2, 1), furrows.ridges.along };
        furrows_ = FurrowNoise { TileTurbulence(bends, 4, kWander),
                                 TileCells(furrows.ridges, 0.95F, kRidges),
                                 TileNoise(furrows.ridges, kFurrowWidth),
                                 TileNoise(furrows.ridges, kRidgeShade),
                                 TileTurbulence(furrows.cracks, 2, kCrackWander),
                                 TileCells(furrows.cracks, 0.9F, kCracks) };
    }
    if (style.flakes.height > 0)
        flakes_ = FlakeNoise { TileTurbulence({ 14, 12 }, 3, kFlakeBend),
                               TileCells(style.flakes.cells, 0.9F, kFlakes) };
    if (style.clefts.share > 0)
        clefts_ = CleftNoise { TileCells(style.clefts.cells, 0.45F, kClefts),
                               TileTurbulence({ 30, 12 }, 3, kCleftEdge),
                               TileTurbulence({ 60, 14 }, 3, kCleftBottom) };
    if (style.patches.share > 0)
        patches_ = PatchNoise { TileTurbulence({ 9, 8 }, 3, kPatchBendU),
                                TileTurbulence({ 9, 8 }, 3, kPatchBendV),
                                TileCells(style.patches.cells, 0.95F, kPatches) };
}

BarkPoint BarkField::at(float u, float v) const
{
    auto const& surface = style_.surface;
    float const blotch = eased_step(0.38F, 0.62F, surface_.blotches.at(u, v));
    float const grain = surface.grain * surface_.grain.signed_at(u, v);
    float const lines = surface.wrinkles * surface_.wrinkles.signed_at(u, v);
    BarkPoint point { .height = 0.6F + 2.4F * grain + lines,
                      .color
                      = mixed(surface.color, surface.other_color, blotch) * (1 + grain + lines),
                      .roughness = surface.roughness };
    if (patches_)
        add_patches(point, u, v);
    if (flakes_)
        add_flakes(point, u, v);
    if (furrows_)
        add_furrows(point, u, v);
    if (style_.lenticels.share > 0)
        add_lenticels(point, u, v);
    if (clefts_)
        add_clefts(point, u, v);
    point.height = std::clamp(point.height, 0.0F, 1.0F);
    point.color = point.color.cwiseMax(0).cwiseMin(1);
    return point;
}

// The older a piece, the darker and higher it is.
void BarkField::add_patches(BarkPoint& point, float u, float v) const
{
    auto const& patches = style_.patches;
    float const bend_u = 0.5F / 9 * patches_->bend_u.signed_at(u, v);
    float const bend_v = 0.5F / 8 * patches_->bend_v.signed_at(u, v);
    auto const cell = patches_->cells.at(u + bend_u, v + bend_v);
    if (cell.random >= patches.share)
        return;
    float const freshness = 1 - cell.random / patches.share;
    point.color = mixed(point.color, patches.fresh, 0.35F + 0.65F * freshness);
    point.height -= (0.15F + 0.3F * freshness) * eased_step(0, 0.05F, cell.to_border);
}

void BarkField::add_flakes(BarkPoint& point, float u, float v) const
{
    auto const& flakes = style_.flakes;
    float const bend = 0.6F * flakes_->bend.signed_at(u, v);
    auto const cell = flakes_->cells.at(u + bend / static_cast<float>(flakes.cells.across),
                                        v + bend / static_cast<float>(flakes.cells.along));
    // A flake is lifted at its lower edge.
    float const lift = 0.5F - 0.6F * cell.offset_v;
    float const edge = 1 - eased_step(0.01F, 0.07F, cell.to_border);
    point.height += flakes.height * (0.5F * lift + 0.4F * (cell.random - 0.5F) - 0.5F * edge);
    point.color *= 1 + flakes.change * (2 * cell.random - 1);
    point.color = mixed(point.color, flakes.edge, 0.75F * edge);
}

void BarkField::add_furrows(BarkPoint& point, float u, float v) const
{
    auto const& furrows = style_.furrows;
    float const wander = furrows.wander / static_cast<float>(furrows.ridges.across);
    float const bent_u = u + wander * furrows_->wander.signed_at(u, v);
    auto const cell = furrows_->ridges.at(bent_u, v);
    float const across = cell.border_tilt * cell.border_tilt * furrows.bridges;
    float const width = furrows.width * (0.65F + 0.7F * furrows_->width.at(u, v));
    float const depth
        = (1 - eased_step(0.15F * width, width, cell.to_border)) * (1 - 0.92F * across);
    float crack = 0;
    if (furrows.crack_depth > 0) {
        auto const piece = furrows_->cracks.at(
            bent_u + 0.4F * wander * furrows_->crack_wander.signed_at(u, v), v);
        crack = furrows.crack_depth * (1 - eased_step(0.02F, 0.16F, piece.to_border)) * (1 - depth);
        point.color *= 1 + 0.10F * (2 * piece.random - 1);
        point.height += 0.10F * (piece.random - 0.5F);
    }
    float const rounded = 0.3F * eased_step(0, 2.5F * width, cell.to_border);
    point.height = (0.62F * point.height + 0.13F + rounded) * (1 - depth) - 0.5F * crack;
    point.color *= 1 + 0.10F * (2 * furrows_->shade.at(u, v) - 1);
    point.color = mixed(point.color, furrows.color, std::min(1.0F, 0.95F * depth + crack));
    point.roughness = std::max(point.roughness, 0.9F * depth);
}

void BarkField::add_lenticels(BarkPoint& point, float u, float v) const
{
    auto const& pores = style_.lenticels;
    float const x = u * static_cast<float>(pores.cells.across);
    float const y = v * static_cast<float>(pores.cells.along);
    auto const column = static_cast<int>(std::floor(x));
    auto const row = static_cast<int>(std::floor(y));
    // Long ones reach into the neighbouring cells.
    for (int i = column - 1; i <= column + 1; ++i) {
        auto const random = [&](std::uint32_t which) {
            return tile_random(i, row, pores.cells, kLenticels + which);
        };
        if (random(0) >= pores.share)
            continue;
        float const half = 0.5F * pores.length * (0.4F + 1.6F * random(1) * random(1));
        float const du = (x - (static_cast<float>(i) + 0.2F + 0.6F * random(2))) / half;
        float const thickness = pores.thickness * (0.6F + 0.8F * random(3));
        float const dv = (y - (static_cast<float>(row) + 0.3F + 0.4F * random(4))) / thickness;
        float const inside = 1 - eased_step(0.5F, 1, du * du * du * du + dv * dv);
        point.color = mixed(point.color, pores.color, 0.85F * inside);
        point.height += pores.height * inside;
    }
}

void BarkField::add_clefts(BarkPoint& point, float u, float v) const
{
    auto const& clefts = style_.clefts;
    auto const cell = clefts_->cells.at(u, v);
    if (cell.random >= clefts.share)
        return;
    float const size = clefts.size * (0.45F + 0.55F * cell.random / clefts.share);
    float const ragged = 0.35F * clefts_->edge.signed_at(u, v);
    // The cells' borders bound the rhombus.
    float const near_border = 1 - eased_step(0, 0.1F, cell.to_border);
    float const from_middle = std::abs(cell.offset_u) / size
        + std::abs(cell.offset_v) / (1.15F * size) + ragged + near_border;
    float const inside = 1 - eased_step(0.78F, 1, from_middle);
    float const rough = clefts_->bottom.at(u, v);
    point.color = mixed(point.color, clefts.color * (0.6F + 1.1F * rough), inside);
    point.height += inside * (rough - 0.75F);
    point.roughness += inside * (0.95F - point.roughness);
}

} // namespace tractus::exports
