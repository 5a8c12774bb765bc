#include "engine/methods/leaves/paint_raster.h"

#include "engine/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tractus::leaf {

namespace {

constexpr int kBlock = 4; // Side of a block of TileGrid::blocks_, in pixels.
constexpr int kBlocks = TileGrid::kTile / kBlock;

std::size_t pixels(int value)
{
    return static_cast<std::size_t>(value);
}

} // namespace

void TileGrid::find(std::span<float const> coverage, int side)
{
    side_ = side;
    columns_ = (side + TileGrid::kTile - 1) / TileGrid::kTile;
    // Number of blocks in a row of the picture, with a margin of one block on both sides.
    auto const blocks = pixels(columns_ * kBlocks) + 2;
    blocks_.assign(blocks * blocks, 0);
    for (int y = 0; y < side; ++y) {
        auto const* const row = coverage.data() + pixels(y) * pixels(side);
        auto* const marks = blocks_.data() + (pixels(y / kBlock) + 1) * blocks + 1;
        for (int x = 0; x < side; ++x)
            marks[x / kBlock] = marks[x / kBlock] | static_cast<std::uint8_t>(row[x] > 0);
    }
    is_near_.assign(pixels(columns_) * pixels(columns_), 0);
    for (int row = 0; row < columns_; ++row)
        for (int column = 0; column < columns_; ++column)
            for (int j = 0; j < kBlocks + 2; ++j) {
                auto const* const marks = blocks_.data() + pixels(row * kBlocks + j) * blocks
                    + pixels(column * kBlocks);
                if (std::any_of(marks, marks + kBlocks + 2, [](auto mark) { return mark != 0; }))
                    is_near_[index(column, row)] = 1;
            }
}

void CoverageRaster::begin(int side)
{
    side_ = side;
    sums_.assign(pixels(side) * pixels(side + 2), 0);
}

void CoverageRaster::add_triangle(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    double const turn = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    auto const& second = turn < 0 ? c : b;
    auto const& third = turn < 0 ? b : c;
    add_line(a, second);
    add_line(second, third);
    add_line(third, a);
}

void CoverageRaster::finish(std::vector<float>& coverage) const
{
    constexpr double kRounding = 1e-3; // Coverage within this distance of 0 or 1 is rounded to it.
    coverage.resize(pixels(side_) * pixels(side_));
    auto* to = coverage.data();
    for (int y = 0; y < side_; ++y) {
        double sum = 0;
        auto const* const row = sums_.data() + pixels(y) * pixels(side_ + 2);
        for (int x = 0; x < side_; ++x) {
            sum -= double(row[x]);
            *to++ = sum < kRounding ? 0 : sum > 1 - kRounding ? 1 : static_cast<float>(sum);
        }
    }
}

void CoverageRaster::add_line(Vec2 const& a, Vec2 const& b)
{
    if (a.y() == b.y())
        return;
    double const sign = a.y() < b.y() ? 1 : -1;
    Vec2 const& top = a.y() < b.y() ? a : b;
    Vec2 const& bottom = a.y() < b.y() ? b : a;
    double const slope = (bottom.x() - top.x()) / (bottom.y() - top.y());
    double const begin = std::max(0.0, top.y());
    double const end = std::min(double(side_), bottom.y());
    for (int y = static_cast<int>(begin); y < end; ++y) {
        double const y0 = std::max(begin, double(y));
        double const y1 = std::min(end, double(y + 1));
        double const x0 = top.x() + (y0 - top.y()) * slope;
        double const x1 = top.x() + (y1 - top.y()) * slope;
        add_in_row(y, sign * (y1 - y0), std::min(x0, x1), std::max(x0, x1));
    }
}

// Adds a line segment from x0 to x1 within a row of pixels; `height` is its extent in y. Each pixel
// that the segment crosses gets the area beside its part, and the next pixel gets the rest.
void CoverageRaster::add_in_row(int y, double height, double x0, double x1)
{
    double const last = side_;
    x0 = std::clamp(x0, 0.0, last);
    x1 = std::clamp(x1, 0.0, last);
    double const length = x1 - x0;
    int const from = static_cast<int>(x0);
    if (x1 <= from + 1 || length < 1e-12) {
        add_part(from, y, height, 0.5 * (x0 + x1) - from);
        return;
    }
    for (int x = from; x < x1; ++x) {
        double const a = std::max(x0, double(x));
        double const b = std::min(x1, double(x + 1));
        add_part(x, y, height * (b - a) / length, 0.5 * (a + b) - x);
    }
}

void CoverageRaster::add_part(int x, int y, double height, double middle)
{
    auto* const at = sums_.data() + pixels(y) * pixels(side_ + 2) + pixels(x);
    at[0] += static_cast<float>(height * (1 - middle));
    at[1] += static_cast<float>(height * middle);
}

namespace {

using TileRow = Eigen::Array<float, TileGrid::kTile, 1>;

// A vein, prepared for computing its distance from the pixels in a row of a tile.
struct Stroke {
    float x = 0;
    float y = 0;
    float along_x = 0;
    float along_y = 0;
    float per_length2 = 0;
    float half_width = 0;
    float widens = 0;
    float min_half = 0;
    float most_half = 0;
    float order = 1;
    bool is_spared = false;
};

Stroke stroke_of(Leaf::Vein const& vein, int spared_order)
{
    Vec2 const along = vein.to - vein.from;
    double const length2 = along.squaredNorm();
    auto const from = static_cast<float>(vein.half_width_from);
    auto const to = static_cast<float>(vein.half_width_to);
    return { .x = static_cast<float>(vein.from.x()),
             .y = static_cast<float>(vein.from.y()),
             .along_x = static_cast<float>(along.x()),
             .along_y = static_cast<float>(along.y()),
             .per_length2 = length2 > 0 ? static_cast<float>(1 / length2) : 0,
             .half_width = from,
             .widens = to - from,
             .min_half = std::min(from, to),
             .most_half = std::max(from, to),
             .order = static_cast<float>(std::min(vein.order, 9)),
             .is_spared = vein.order <= spared_order };
}

float from_middle(Stroke const& stroke, float x, float y)
{
    float const dx = x - stroke.x;
    float const dy = y - stroke.y;
    float const t
        = std::clamp((dx * stroke.along_x + dy * stroke.along_y) * stroke.per_length2, 0.0f, 1.0f);
    float const px = dx - t * stroke.along_x;
    float const py = dy - t * stroke.along_y;
    return std::sqrt(px * px + py * py);
}

class TileMapper {
public:
    TileMapper(std::span<Stroke const> strokes, int side, VeinMapOptions const& options,
               VeinMaps const& maps)
        : strokes_(strokes)
        , side_(side)
        , fade_(std::max(1.0f, 0.004f * static_cast<float>(side)))
        , reach_(options.reach)
        , maps_(maps)
    {
    }

    void map(int column, int row)
    {
        x0_ = column * TileGrid::kTile;
        auto const y0 = row * TileGrid::kTile;
        choose(static_cast<float>(x0_) + 0.5f * TileGrid::kTile,
               static_cast<float>(y0) + 0.5f * TileGrid::kTile);
        for (int y = y0; y < std::min(side_, y0 + TileGrid::kTile); ++y)
            map_row(y);
    }

private:
    // Selects the veins that may be nearest to a pixel of the tile at (x, y), or so close to it
    // that their profile or protection matters.
    void choose(float x, float y)
    {
        constexpr float kHalfDiagonal = 0.7072f * TileGrid::kTile;
        chosen_.clear();
        bounds_.clear();
        float nearest = reach_;
        for (auto const& stroke : strokes_) {
            bounds_.push_back(from_middle(stroke, x, y));
            nearest = std::min(nearest, bounds_.back() + kHalfDiagonal - stroke.min_half);
        }
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            auto const& stroke = strokes_[i];
            float const least = bounds_[i] - kHalfDiagonal;
            float const seen = 1.6f * std::max(stroke.most_half, 0.6f) + fade_;
            if (least - stroke.most_half <= nearest || least <= seen)
                chosen_.push_back(&stroke);
        }
    }

    void map_row(int y)
    {
        distance_ = TileRow::Constant(reach_);
        profile_ = TileRow::Zero();
        protection_ = TileRow::Zero();
        order_ = TileRow::Constant(9);
        for (auto const* const stroke : chosen_)
            add(*stroke, static_cast<float>(y) + 0.5f);
        auto const at = pixels(y) * pixels(side_) + pixels(x0_);
        auto const count = std::min(TileGrid::kTile, side_ - x0_);
        for (int i = 0; i < count; ++i) {
            auto const to = at + pixels(i);
            maps_.distance[to] = distance_[i];
            maps_.profile[to] = profile_[i];
            maps_.protection[to] = protection_[i];
            maps_.order[to] = static_cast<std::uint8_t>(order_[i]);
        }
    }

    void add(Stroke const& stroke, float y)
    {
        TileRow const dx = steps_ + (static_cast<float>(x0_) + 0.5f - stroke.x);
        float const dy = y - stroke.y;
        TileRow const t = ((dx * stroke.along_x + dy * stroke.along_y) * stroke.per_length2)
                              .max(0.0f)
                              .min(1.0f);
        TileRow const half = stroke.half_width + stroke.widens * t;
        TileRow const px = dx - t * stroke.along_x;
        TileRow const py = dy - t * stroke.along_y;
        TileRow const middle2 = px * px + py * py;
        TileRow const middle = middle2.sqrt();
        distance_ = distance_.min((middle - half).max(0.0f));
        TileRow const wide = 1.6f * half.max(0.6f);
        TileRow const inside = (1 - middle2 / (wide * wide)).max(0.0f);
        order_ = (inside > profile_).select(TileRow::Constant(stroke.order), order_);
        profile_ = profile_.max(inside);
        if (stroke.is_spared)
            protection_ = protection_.max(
                1 - ((middle - 1.3f * half.max(0.5f)) / fade_).max(0.0f).min(1.0f));
    }

    std::span<Stroke const> strokes_;
    int side_;
    float fade_; // Number of pixels over which a vein's protection fades.
    float reach_;
    VeinMaps const& maps_;
    int x0_ = 0;
    TileRow const steps_ = TileRow::LinSpaced(0, TileGrid::kTile - 1);
    std::vector<float> bounds_;
    std::vector<Stroke const*> chosen_;
    TileRow distance_;
    TileRow profile_;
    TileRow protection_;
    TileRow order_;
};

} // namespace

void map_veins(std::span<Leaf::Vein const> veins, TileGrid const& tiles,
               VeinMapOptions const& options, VeinMaps const& maps)
{
    auto const count = pixels(tiles.side()) * pixels(tiles.side());
    maps.distance.resize(count);
    maps.profile.resize(count);
    maps.protection.assign(count, 0);
    maps.order.resize(count);
    std::vector<Stroke> strokes;
    strokes.reserve(veins.size());
    for (auto const& vein : veins)
        strokes.push_back(stroke_of(vein, options.spared_order));
    parallel_for(pixels(tiles.columns()), 2, [&](std::size_t begin, std::size_t end) {
        TileMapper mapper(strokes, tiles.side(), options, maps);
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
            for (int column = 0; column < tiles.columns(); ++column)
                if (tiles.is_near(column, row))
                    mapper.map(column, row);
    });
}

} // namespace tractus::leaf
