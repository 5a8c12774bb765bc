#include "engine/methods/leaves/leaf_paint.h"

#include "engine/base/parallel.h"
#include "engine/methods/leaves/paint_noise.h"
#include "engine/methods/leaves/paint_raster.h"
#include "engine/methods/leaves/paint_spread.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <span>
#include <utility>

namespace tractus::leaf {

// Buffers that a LeafPainter reuses for each leaf. All of them are written before they are read.
struct LeafPainter::Canvas {
    LeafPicture picture;
    CoverageRaster raster;
    TileGrid tiles;
    std::vector<float> profile;      // Vein profile: 1 on midlines, 0 beside veins (VeinMaps).
    std::vector<std::uint8_t> order; // Order of the nearest vein (VeinMaps).
    std::vector<float> net;          // Network of the smallest veins, 0 to 1.
    // Map of the parts that larvae have eaten: 1 in holes, decreasing across their rims. Empty if
    // nothing has been eaten.
    std::vector<float> eaten;
    // Opacity of spots at each pixel; `rings`: of the rings around spots, `mines`: of leaf mines.
    // Each is empty if the leaf has none.
    std::vector<float> spots;
    std::vector<float> rings;
    std::vector<float> mines;
    std::vector<double> sums; // Sums of distance from veins and of coverage over each row of tiles.
};

namespace {

constexpr std::uint64_t kMineSeed = 0x6D696E65;
constexpr int kTile = TileGrid::kTile;
using Row = Eigen::Array<float, kTile, 1>;
using RowMap = Eigen::Map<Row>;

double smooth(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

Row smooth(Row x)
{
    x = x.max(0.0f).min(1.0f);
    return x * x * (3 - 2 * x);
}

double to_linear(double c)
{
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Vec3f linear(Vec3 const& srgb)
{
    return srgb.unaryExpr(&to_linear).cast<float>();
}

std::uint8_t byte(float value)
{
    return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0f, 1.0f) + 0.5f);
}

std::uint8_t srgb_byte(float value)
{
    static std::vector<std::uint8_t> const table = [] {
        std::vector<std::uint8_t> made;
        for (int i = 0; i < 4096; ++i) {
            double const c = (i + 0.5) / 4096;
            made.push_back(byte(static_cast<float>(
                c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
        }
        return made;
    }();
    return table[static_cast<std::size_t>(std::clamp(value * 4096, 0.0f, 4095.0f))];
}

struct ColorRow {
    Row red;
    Row green;
    Row blue;

    void fill(Vec3f const& color)
    {
        red = Row::Constant(color.x());
        green = Row::Constant(color.y());
        blue = Row::Constant(color.z());
    }
    void mix(Vec3f const& color, Row const& share)
    {
        red += share * (color.x() - red);
        green += share * (color.y() - green);
        blue += share * (color.z() - blue);
    }
};

// Returns the local age of each pixel in a row, by the same law as age_at().
Row ages(double age, Row const& closeness, Row const& mask, PaintOptions const& options)
{
    auto const veins = static_cast<float>(options.near_veins);
    auto const noise = static_cast<float>(options.noise);
    auto const now = static_cast<float>(age * (1 + options.near_veins + options.noise));
    Row const later
        = options.first == PaintOptions::First::NearVeins ? closeness : Row(1 - closeness);
    return smooth(Row(now - veins * later - noise * mask));
}

} // namespace

// Paints one leaf, using the buffers of a canvas.
class LeafBrush {
public:
    LeafBrush(LeafPainter::Canvas& canvas, PaintOptions const& options, PictureFrame const& frame)
        : canvas_(canvas)
        , picture_(canvas.picture)
        , options_(options)
        , frame_(frame)
        , side_(options.side)
        , veins_ { picture_.distance, canvas.profile, picture_.protection, canvas.order }
        , count_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_))
        , colors_ { linear(options.young), linear(options.old), linear(options.dead) }
        , patches_(NoiseTable::clouds(), options.seed + 2, 7)
        , mottle_(NoiseTable::clouds(), options.seed + 61, 24)
        , mildew_(NoiseTable::clouds(), options.seed + 83, 9)
    {
    }

    void paint(Leaf const& leaf, LeafTriangles const& triangles)
    {
        picture_.side = side_;
        cover(triangles);
        map_veins(leaf);
        measure_closeness();
        damage(leaf);
        find_heights();
        picture_.color.resize(count_);
        picture_.normal.resize(count_);
        picture_.roughness.resize(count_);
        picture_.translucency.resize(count_);
        picture_.age.resize(count_);
        auto const underside = options_.has_underside ? count_ : 0;
        picture_.under_color.resize(underside);
        picture_.under_normal.resize(underside);
        for_tiles([&](int column, int row) { paint_tile(column, row); });
        spread_colors(picture_, canvas_.tiles);
    }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_)
            + static_cast<std::size_t>(x);
    }

    template<typename Work> void for_tiles(Work const& work) const
    {
        auto const& tiles = canvas_.tiles;
        parallel_for(
            static_cast<std::size_t>(tiles.columns()), 2, [&](std::size_t begin, std::size_t end) {
                for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
                    for (int column = 0; column < tiles.columns(); ++column)
                        if (tiles.is_near(column, row))
                            work(column, row);
            });
    }

    // Calls work(index of the first pixel, number of pixels, y) for each row of pixels of a tile,
    // without pixels outside the picture.
    template<typename Work> void for_rows(int column, int row, Work const& work) const
    {
        int const x = column * kTile;
        int const end = std::min(side_, (row + 1) * kTile);
        for (int y = row * kTile; y < end; ++y)
            work(index(x, y), std::min(kTile, side_ - x), y);
    }

    // Reads a row of `count` pixels of a map from the index `at` on; the rest of the result is 0.
    static Row read(std::vector<float> const& from, std::size_t at, int count)
    {
        Row made;
        if (count == kTile)
            made = Eigen::Map<Row const>(from.data() + at);
        else
            for (int i = 0; i < kTile; ++i)
                made[i] = i < count ? from[at + static_cast<std::size_t>(i)] : 0;
        return made;
    }
    static void write(std::vector<float>& to, std::size_t at, int count, Row const& row)
    {
        std::copy_n(row.data(), count, to.data() + at);
    }

    Row sample(Noise const& noise, int column, int y) const
    {
        Row made;
        float const per_side = 1 / static_cast<float>(side_);
        float const v = (static_cast<float>(y) + 0.5f) * per_side;
        for (int i = 0; i < kTile; ++i)
            made[i] = noise.at((static_cast<float>(column * kTile + i) + 0.5f) * per_side, v);
        return made;
    }

    void cover(LeafTriangles const& triangles)
    {
        canvas_.raster.begin(side_);
        pixels_.reserve(triangles.flat.size());
        for (auto const& flat : triangles.flat)
            pixels_.push_back(frame_.pixel(flat));
        for (auto const& part : { std::span(triangles.veins), std::span(triangles.limb) })
            for (auto const& [a, b, c] : part)
                canvas_.raster.add_triangle(pixels_[a], pixels_[b], pixels_[c]);
        canvas_.raster.finish(picture_.coverage);
        picture_.alpha = picture_.coverage;
        canvas_.tiles.find(picture_.coverage, side_);
    }

    void map_veins(Leaf const& leaf)
    {
        auto veins = leaf.veins();
        for (auto& vein : veins) {
            vein.from = frame_.pixel(vein.from);
            vein.to = frame_.pixel(vein.to);
            vein.half_width_from *= frame_.scale;
            vein.half_width_to *= frame_.scale;
        }
        base_ = veins.empty() ? Vec2(0, 0) : veins.front().from;
        picture_.reach = 0.16f * static_cast<float>(side_);
        leaf::map_veins(
            veins, canvas_.tiles,
            { .reach = picture_.reach,
              .spared_order = options_.is_skeleton ? INT_MAX : options_.larvae.spared_order },
            veins_);
    }

    // Finds the distance from veins at which the closeness D is 1: half-way between veins. Between
    // parallel veins the mean distance is a quarter of their gap, so this distance is twice the
    // mean.
    void measure_closeness()
    {
        auto const& distance = veins_.distance;
        auto const rows = static_cast<std::size_t>(canvas_.tiles.columns());
        canvas_.sums.assign(2 * rows, 0);
        for_tiles([&](int column, int row) {
            auto* const sum = &canvas_.sums[2 * static_cast<std::size_t>(row)];
            for_rows(column, row, [&](std::size_t at, int count, int) {
                Row const covered = read(picture_.coverage, at, count);
                sum[0] += double((covered * read(distance, at, count)).sum());
                sum[1] += double(covered.sum());
            });
        });
        double sum = 0;
        double area = 0;
        for (std::size_t i = 0; i < rows; ++i) {
            sum += canvas_.sums[2 * i];
            area += canvas_.sums[2 * i + 1];
        }
        radius_ = area > 0 ? std::max(1.0, 2 * sum / area) : 1;
        picture_.closeness.resize(count_);
    }

    void damage(Leaf const& leaf)
    {
        LarvaGround const ground { side_, picture_.coverage, veins_.protection };
        canvas_.eaten.clear();
        if (options_.is_skeleton)
            for (std::size_t i = 0; i < count_; ++i)
                picture_.alpha[i] *= veins_.protection[i];
        if (options_.larvae.count > 0) {
            canvas_.eaten.assign(count_, 0);
            eat(ground, options_.larvae, options_.seed, picture_.alpha, canvas_.eaten);
        }
        if (options_.larvae.count > 0 || options_.is_skeleton)
            keep_connected(ground, base_, picture_.alpha);
        canvas_.mines.clear();
        if (options_.mines > 0) {
            canvas_.mines.assign(count_, 0);
            mine(ground, options_.mines, options_.seed ^ kMineSeed, canvas_.mines);
        }
        canvas_.spots.clear();
        if (options_.spots > 0 && !leaf.veins().empty())
            add_spots();
    }

    // Adds brown spots: at most one in each square of a grid, at a random position in the square.
    void add_spots()
    {
        constexpr int kSquares = 16;
        canvas_.spots.assign(count_, 0);
        canvas_.rings.assign(count_, 0);
        double const square = double(side_) / kSquares;
        for (int j = 0; j < kSquares; ++j)
            for (int i = 0; i < kSquares; ++i)
                if (grid_hash(options_.seed + 84, i, j) < options_.spots)
                    add_spot({ square * (i + grid_hash(options_.seed + 71, i, j)),
                               square * (j + grid_hash(options_.seed + 78, i, j)) },
                             square * (0.12 + 0.25 * grid_hash(options_.seed + 73, i, j)));
    }

    void add_spot(Vec2 const& at, double radius)
    {
        double const square = side_ / 16.0;
        double const far = radius + 0.05 * square;
        int const x0 = std::max(0, static_cast<int>(at.x() - far));
        int const y0 = std::max(0, static_cast<int>(at.y() - far));
        for (int y = y0; y < std::min<double>(side_, at.y() + far); ++y)
            for (int x = x0; x < std::min<double>(side_, at.x() + far); ++x) {
                double const distance = (Vec2(x + 0.5, y + 0.5) - at).norm();
                auto const i = index(x, y);
                canvas_.spots[i] = std::max(
                    canvas_.spots[i],
                    static_cast<float>(smooth((radius - distance) / (0.08 * square) + 0.5)));
                canvas_.rings[i] = std::max(
                    canvas_.rings[i],
                    static_cast<float>(smooth((0.7 * radius - distance) / (0.05 * square) + 0.5)));
            }
    }

    // Computes the heights of the relief: veins are raised, the limb between them is vaulted, and
    // the smallest veins form a closed net.
    void find_heights()
    {
        picture_.height.assign(count_, 0);
        canvas_.net.resize(count_);
        double const meshes = std::clamp(0.28 * side_ / radius_, 12.0, 70.0);
        Noise const net(NoiseTable::net(), options_.seed + 41, meshes);
        Noise const grain(NoiseTable::clouds(), options_.seed + 51, 60);
        auto const per_radius = static_cast<float>(1 / radius_);
        for_tiles([&](int column, int row) {
            for_rows(column, row, [&](std::size_t at, int count, int y) {
                Row const d = (read(veins_.distance, at, count) * per_radius).min(1.0f);
                Row const fine = sample(net, column, y);
                Row const v = read(veins_.profile, at, count);
                write(picture_.closeness, at, count, d);
                write(canvas_.net, at, count, fine);
                write(picture_.height, at, count,
                      0.5f * v - 0.25f * (d * (-1 / 0.35f)).exp() + 0.1f * fine
                          + 0.03f * sample(grain, column, y));
            });
        });
    }

    void paint_tile(int column, int row)
    {
        for_rows(column, row, [&](std::size_t at, int count, int y) {
            Row const d = read(picture_.closeness, at, count);
            Row const v = read(veins_.profile, at, count);
            Row const net = read(canvas_.net, at, count);
            Row const mask = masks(column, y);
            Row const m = ages(options_.age, d, mask, options_);
            write(picture_.age, at, count, m);
            ColorRow color;
            color.fill(colors_[0]);
            color.mix(colors_[1], m);
            if (options_.dead_age > 0)
                color.mix(colors_[2], ages(options_.dead_age, d, mask, options_));
            mottle(color, sample(mottle_, column, y), d);
            draw_veins(color, at, count, v, net);
            Row const white = add_damage(color, at, count, column, y);
            store_color(color, at, count);
            if (options_.has_underside)
                store_under_color(color, v, at, count);
            store_normals(at, count, column * kTile, y);
            store_surface({ d, v, net, m, white }, at, count);
        });
    }

    // Returns the delay of ageing, 0 to 1, for each pixel of one row of pixels in a tile.
    Row masks(int column, int y) const
    {
        Row const patches = smooth(Row(1.6f * sample(patches_, column, y) - 0.3f));
        auto const tip = static_cast<float>(std::clamp(options_.tip, 0.0, 1.0));
        float const from_tip = (static_cast<float>(y) + 0.5f) / static_cast<float>(side_);
        return (1 - tip) * patches + tip * from_tip;
    }

    // Mottles the leaf slightly and makes it a little darker along its veins.
    static void mottle(ColorRow& color, Row const& clouds, Row const& d)
    {
        Row const share = 0.82f + 0.36f * clouds + 0.08f * (d - 0.5f);
        color.red *= share;
        color.green *= share;
        color.blue *= share;
    }

    void draw_veins(ColorRow& color, std::size_t at, int count, Row const& v, Row const& net) const
    {
        constexpr float kTinted = 0.55f;
        static Vec3f const tint = linear({ 0.90, 0.91, 0.66 });
        Row strength;
        for (int i = 0; i < kTile; ++i)
            strength[i]
                = i < count && veins_.order[at + static_cast<std::size_t>(i)] <= 1 ? 0.75f : 0.5f;
        color.mix(tint, kTinted * (strength * v + (1 - v) * 0.14f * net));
    }

    // Adds the colours of spots, mines, a skeleton, mildew and the rims of holes. Returns the
    // opacity of the mildew.
    Row add_damage(ColorRow& color, std::size_t at, int count, int column, int y) const
    {
        static Vec3f const spot = linear({ 0.26, 0.13, 0.06 });
        static Vec3f const ring = linear({ 0.52, 0.38, 0.22 });
        static Vec3f const mined = linear({ 0.82, 0.80, 0.62 });
        static Vec3f const bone = linear({ 0.55, 0.42, 0.26 });
        static Vec3f const rim = linear({ 0.36, 0.21, 0.09 });
        static Vec3f const powder = linear({ 0.86, 0.87, 0.83 });
        if (!canvas_.spots.empty()) {
            color.mix(spot, 0.85f * read(canvas_.spots, at, count));
            color.mix(ring, 0.7f * read(canvas_.rings, at, count));
        }
        if (!canvas_.mines.empty())
            color.mix(mined, 0.85f * read(canvas_.mines, at, count));
        if (options_.is_skeleton)
            color.mix(bone, Row::Constant(0.8f));
        Row white = Row::Zero();
        if (options_.mildew > 0) {
            auto const share = static_cast<float>(0.25 + 0.5 * options_.mildew);
            white = 0.8f * smooth(Row((share - sample(mildew_, column, y)) / 0.12f));
            color.mix(powder, white);
        }
        if (!canvas_.eaten.empty())
            color.mix(rim, 0.7f * read(canvas_.eaten, at, count));
        return white;
    }

    void store_color(ColorRow const& color, std::size_t at, int count)
    {
        for (int i = 0; i < count; ++i) {
            auto const to = at + static_cast<std::size_t>(i);
            picture_.color[to] = { srgb_byte(color.red[i]), srgb_byte(color.green[i]),
                                   srgb_byte(color.blue[i]), byte(picture_.alpha[to]) };
        }
    }

    // Stores the colour of the underside, which is paler, especially along veins.
    void store_under_color(ColorRow color, Row const& v, std::size_t at, int count)
    {
        static Vec3f const pale = linear({ 0.74, 0.80, 0.66 });
        color.mix(pale, 0.3f + 0.3f * v);
        for (int i = 0; i < count; ++i)
            picture_.under_color[at + static_cast<std::size_t>(i)]
                = { srgb_byte(color.red[i]), srgb_byte(color.green[i]), srgb_byte(color.blue[i]) };
    }

    float height_at(int x, int y) const
    {
        return picture_.height[index(std::clamp(x, 0, side_ - 1), std::clamp(y, 0, side_ - 1))];
    }

    void store_normals(std::size_t at, int count, int x0, int y)
    {
        auto const strength = static_cast<float>(0.003 * side_);
        Row du;
        Row dv;
        for (int i = 0; i < kTile; ++i) {
            int const x = x0 + i;
            du[i] = height_at(x - 1, y) - height_at(x + 1, y);
            dv[i] = height_at(x, y + 1) - height_at(x, y - 1);
        }
        put_normals(picture_.normal, strength * du, strength * dv, at, count);
        if (options_.has_underside)
            put_normals(picture_.under_normal, -2 * strength * du, -2 * strength * dv, at, count);
    }

    static void put_normals(std::vector<std::array<std::uint8_t, 3>>& to, Row const& x,
                            Row const& y, std::size_t at, int count)
    {
        Row const per_length = (x * x + y * y + 1).sqrt().inverse();
        for (int i = 0; i < count; ++i)
            to[at + static_cast<std::size_t>(i)]
                = { byte(0.5f + 0.5f * x[i] * per_length[i]),
                    byte(0.5f + 0.5f * y[i] * per_length[i]), byte(0.5f + 0.5f * per_length[i]) };
    }

    struct Surface {
        Row const& d;
        Row const& v;
        Row const& net;
        Row const& m;
        Row const& white;
    };
    void store_surface(Surface const& s, std::size_t at, int count)
    {
        Row const rough = (0.42f + 0.2f * s.m + 0.08f * s.net - 0.05f * s.v + 0.3f * s.white)
                              .max(0.35f)
                              .min(0.7f);
        Row const occlusion = 1 - 0.25f * (s.d * -5.0f).exp() * (1 - s.v);
        Row const through
            = (0.55f - 0.2f * s.m) * (1 - 0.75f * s.v) * (1 - 0.2f * s.net) * (1 - 0.5f * s.white);
        for (int i = 0; i < count; ++i) {
            auto const to = at + static_cast<std::size_t>(i);
            picture_.roughness[to] = { byte(occlusion[i]), byte(rough[i]), 0 };
            picture_.translucency[to] = byte(through[i]);
        }
    }

    LeafPainter::Canvas& canvas_;
    LeafPicture& picture_;
    PaintOptions const& options_;
    PictureFrame const& frame_;
    int side_;
    VeinMaps veins_;
    std::size_t count_;           // Number of pixels in the picture.
    std::array<Vec3f, 3> colors_; // Colours of a young, an old and a dead leaf, linear RGB.
    Noise patches_;
    Noise mottle_;
    Noise mildew_;
    std::vector<Vec2> pixels_; // Pixel coordinates of the leaf's vertices.
    Vec2 base_ = Vec2::Zero();
    double radius_ = 1; // Distance from veins, in pixels, at which the closeness D is 1.
};

PictureFrame::PictureFrame(LeafTriangles const& leaf, int side, PicturePlacement const& stand)
{
    Eigen::AlignedBox2d box;
    for (auto const& flat : leaf.flat)
        box.extend(flat);
    if (leaf.flat.empty() || !(box.sizes().maxCoeff() > 0))
        return;
    bool const is_on_stem = stand.middle == PicturePlacement::Middle::Stem;
    double const middle = is_on_stem ? 0 : box.center().x();
    double const half = std::max(box.max().x() - middle, middle - box.min().x());
    scale = (1 - 2 * stand.margin) * side / std::max(2 * half, box.sizes().y());
    origin = { middle, box.min().y() };
    x0 = 0.5 * side;
    y0 = (1 - stand.margin) * side;
}

double age_at(double age, double closeness, double noise, PaintOptions const& options)
{
    double const later
        = options.first == PaintOptions::First::NearVeins ? closeness : 1 - closeness;
    return smooth(age * (1 + options.near_veins + options.noise) - options.near_veins * later
                  - options.noise * noise);
}

LeafPainter::LeafPainter()
    : canvas_(std::make_unique<Canvas>())
{
}
LeafPainter::~LeafPainter() = default;
LeafPainter::LeafPainter(LeafPainter&&) noexcept = default;
LeafPainter& LeafPainter::operator=(LeafPainter&&) noexcept = default;

LeafPicture const& LeafPainter::paint(Leaf const& leaf, LeafTriangles const& triangles,
                                      PaintOptions const& options)
{
    PictureFrame const frame(triangles, options.side, options.stand);
    LeafBrush(*canvas_, options, frame).paint(leaf, triangles);
    return canvas_->picture;
}

LeafPicture paint_leaf(Leaf const& leaf, LeafTriangles const& triangles,
                       PaintOptions const& options)
{
    return LeafPainter().paint(leaf, triangles, options);
}

} // namespace tractus::leaf
