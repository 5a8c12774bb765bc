#include "engine/methods/leaves/leaf_paint.h"

#include "engine/base/parallel.h"
#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tractus::leaf {

namespace {

constexpr std::uint32_t kNoiseStream = 2;
constexpr std::uint32_t kLarvaStream = 3;
constexpr double kMargin = 0.03; // Of the picture's side, all round the leaf.

double smooth(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

Vec3 mix(Vec3 const& a, Vec3 const& b, double share)
{
    return a + share * (b - a);
}

Vec3 linear(Vec3 const& srgb)
{
    return srgb.unaryExpr(
        [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
}

std::uint8_t byte(double value)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

std::uint8_t srgb_byte(double value)
{
    static std::vector<std::uint8_t> const table = [] {
        std::vector<std::uint8_t> made;
        for (int i = 0; i < 4096; ++i) {
            double const c = (i + 0.5) / 4096;
            made.push_back(byte(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055));
        }
        return made;
    }();
    return table[static_cast<std::size_t>(std::clamp(value * 4096, 0.0, 4095.0))];
}

// A number from 0 to 1 for a point of a grid.
double hash(std::uint64_t seed, std::int64_t x, std::int64_t y)
{
    auto word = seed * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(x) * 0xBF58476D1CE4E5B9u
        + static_cast<std::uint64_t>(y) * 0x94D049BB133111EBu;
    word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9u;
    word = (word ^ (word >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((word ^ (word >> 31)) >> 11) * 0x1p-53;
}

double value_noise(std::uint64_t seed, Vec2 const& at)
{
    double const x = std::floor(at.x());
    double const y = std::floor(at.y());
    double const u = smooth(at.x() - x);
    double const v = smooth(at.y() - y);
    auto const i = static_cast<std::int64_t>(x);
    auto const j = static_cast<std::int64_t>(y);
    double const low = std::lerp(hash(seed, i, j), hash(seed, i + 1, j), u);
    double const high = std::lerp(hash(seed, i, j + 1), hash(seed, i + 1, j + 1), u);
    return std::lerp(low, high, v);
}

// Three octaves.
double cloud(std::uint64_t seed, Vec2 const& at)
{
    return (4 * value_noise(seed, at) + 2 * value_noise(seed + 1, 2.1 * at)
            + value_noise(seed + 2, 4.3 * at))
        / 7;
}

struct Cells {
    double border = 0;   // From the border between two cells: 0 on it, about 0.5 in the middle.
    double distance = 0; // From the nearest cell's point.
    double number = 0;   // The nearest cell's own, 0 to 1.
};

// Cells round points thrown one to a square (Worley, "A cellular texture basis function", 1996).
Cells cells(std::uint64_t seed, Vec2 const& at)
{
    double first = 1e9;
    double second = 1e9;
    Cells made;
    auto const x = static_cast<std::int64_t>(std::floor(at.x()));
    auto const y = static_cast<std::int64_t>(std::floor(at.y()));
    for (auto j = y - 1; j <= y + 1; ++j)
        for (auto i = x - 1; i <= x + 1; ++i) {
            Vec2 const point(double(i) + hash(seed, i, j), double(j) + hash(seed + 7, i, j));
            double const distance = (point - at).squaredNorm();
            if (distance < first) {
                second = first;
                first = distance;
                made.number = hash(seed + 13, i, j);
            } else {
                second = std::min(second, distance);
            }
        }
    made.border = std::sqrt(second) - std::sqrt(first);
    made.distance = std::sqrt(first);
    return made;
}

// Adds a line to sums of signed areas: its share of each pixel it crosses, in that pixel, and the
// rest of the row in the next one. Summed along rows they give the pixels' coverage.
class Coverage {
public:
    explicit Coverage(int side)
        : side_(side)
        , sums_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side + 2))
    {
    }

    void add_triangle(Vec2 a, Vec2 b, Vec2 c)
    {
        double const turn = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        if (turn < 0)
            std::swap(b, c);
        add_line(a, b);
        add_line(b, c);
        add_line(c, a);
    }

    std::vector<float> pixels() const
    {
        std::vector<float> made;
        for (int y = 0; y < side_; ++y) {
            double sum = 0;
            for (int x = 0; x < side_; ++x) {
                sum += sums_[index(x, y)];
                double const covered = std::clamp(-sum, 0.0, 1.0);
                made.push_back(static_cast<float>(covered < 1e-6 ? 0 : covered));
            }
        }
        return made;
    }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_ + 2)
            + static_cast<std::size_t>(x);
    }

    void add_line(Vec2 const& a, Vec2 const& b)
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

    // A line within a row: `height` of it, from x0 to x1.
    void add_in_row(int y, double height, double x0, double x1)
    {
        double const last = side_;
        x0 = std::clamp(x0, 0.0, last);
        x1 = std::clamp(x1, 0.0, last);
        double const length = x1 - x0;
        int const from = static_cast<int>(x0);
        if (length < 1e-12) {
            add_part(from, y, height, x0 - from);
            return;
        }
        for (int x = from; x < x1; ++x) {
            double const a = std::max(x0, double(x));
            double const b = std::min(x1, double(x + 1));
            add_part(x, y, height * (b - a) / length, 0.5 * (a + b) - x);
        }
    }

    // `middle`: 0 at the pixel's left side, 1 at its right.
    void add_part(int x, int y, double height, double middle)
    {
        sums_[index(x, y)] += height * (1 - middle);
        sums_[index(x + 1, y)] += height * middle;
    }

    int side_;
    std::vector<double> sums_;
};

class Painter {
public:
    Painter(Leaf const& leaf, LeafTriangles const& triangles, PaintOptions const& options)
        : options_(options)
        , frame_(triangles, options.side)
        , side_(options.side)
    {
        picture_.side = side_;
        cover(triangles);
        veins_ = leaf.veins();
        for (auto& vein : veins_) {
            vein.from = frame_.pixel(vein.from);
            vein.to = frame_.pixel(vein.to);
            vein.half_width_from *= frame_.scale;
            vein.half_width_to *= frame_.scale;
        }
        base_ = veins_.empty() ? Vec2(0, 0) : veins_.front().from;
    }

    LeafPicture paint() &&
    {
        measure_distances();
        measure_closeness();
        eat();
        keep_connected();
        find_heights();
        auto const count = static_cast<std::size_t>(side_);
        picture_.color.resize(count * count);
        picture_.normal.resize(count * count);
        picture_.roughness.resize(count * count);
        picture_.translucency.resize(count * count);
        picture_.age.resize(count * count);
        parallel_for(count, 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y)
                for (std::size_t x = 0; x < count; ++x)
                    paint_pixel(static_cast<int>(x), static_cast<int>(y));
        });
        return std::move(picture_);
    }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_)
            + static_cast<std::size_t>(x);
    }

    void cover(LeafTriangles const& triangles)
    {
        Coverage coverage(side_);
        for (auto const& part : { std::span(triangles.veins), std::span(triangles.limb) })
            for (auto const& [a, b, c] : part)
                coverage.add_triangle(frame_.pixel(triangles.flat[a]),
                                      frame_.pixel(triangles.flat[b]),
                                      frame_.pixel(triangles.flat[c]));
        picture_.coverage = coverage.pixels();
        picture_.alpha = picture_.coverage;
    }

    struct Near {
        double distance = 0; // From the vein's side, negative inside.
        double half_width = 0;
    };
    static Near near_vein(Leaf::Vein const& vein, Vec2 const& at)
    {
        Vec2 const side = vein.to - vein.from;
        double const length2 = side.squaredNorm();
        double const part
            = length2 > 0 ? std::clamp((at - vein.from).dot(side) / length2, 0.0, 1.0) : 0;
        double const half = std::lerp(vein.half_width_from, vein.half_width_to, part);
        return { (at - vein.from - part * side).norm() - half, half };
    }

    // Each vein within its box and the reach.
    void measure_distances()
    {
        auto const count = picture_.coverage.size();
        picture_.reach = 0.16f * static_cast<float>(side_);
        picture_.distance.assign(count, picture_.reach);
        picture_.protection.assign(count, 0);
        profile_.assign(count, 0);
        vein_order_.assign(count, 9);
        parallel_for(static_cast<std::size_t>(side_), 16, [&](std::size_t begin, std::size_t end) {
            for (auto const& vein : veins_)
                measure_vein(vein, static_cast<int>(begin), static_cast<int>(end));
        });
    }

    void measure_vein(Leaf::Vein const& vein, int first_row, int rows_end)
    {
        double const reach
            = picture_.reach + std::max(vein.half_width_from, vein.half_width_to) + 1;
        auto const low = vein.from.cwiseMin(vein.to);
        auto const high = vein.from.cwiseMax(vein.to);
        int const x0 = std::clamp(static_cast<int>(low.x() - reach), 0, side_);
        int const x1 = std::clamp(static_cast<int>(high.x() + reach) + 1, 0, side_);
        int const y0 = std::clamp(static_cast<int>(low.y() - reach), first_row, rows_end);
        int const y1 = std::clamp(static_cast<int>(high.y() + reach) + 1, first_row, rows_end);
        bool const is_spared = options_.is_skeleton || vein.order <= options_.larvae.spared_order;
        double const fade = std::max(1.0, 0.004 * side_);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                auto const [distance, half] = near_vein(vein, { x + 0.5, y + 0.5 });
                auto const i = index(x, y);
                auto& nearest = picture_.distance[i];
                nearest = std::min(nearest, static_cast<float>(std::max(0.0, distance)));
                double const from_middle = distance + half;
                double const wide = 1.6 * std::max(half, 0.6);
                double const inside = std::max(0.0, 1 - std::pow(from_middle / wide, 2));
                if (inside > profile_[i]) {
                    profile_[i] = static_cast<float>(inside);
                    vein_order_[i] = static_cast<std::uint8_t>(std::min(vein.order, 9));
                }
                if (is_spared) {
                    double const kept = 1
                        - std::clamp((from_middle - 1.3 * std::max(half, 0.5)) / fade, 0.0, 1.0);
                    picture_.protection[i]
                        = std::max(picture_.protection[i], static_cast<float>(kept));
                }
            }
    }

    // D is 1 halfway between veins: for parallel ones the mean distance is a quarter of the gap.
    void measure_closeness()
    {
        double sum = 0;
        double area = 0;
        for (std::size_t i = 0; i < picture_.coverage.size(); ++i) {
            sum += double(picture_.coverage[i]) * double(picture_.distance[i]);
            area += double(picture_.coverage[i]);
        }
        radius_ = area > 0 ? std::max(1.0, 2 * sum / area) : 1;
        for (auto const distance : picture_.distance)
            picture_.closeness.push_back(
                static_cast<float>(std::min(1.0, double(distance) / radius_)));
    }

    void eat()
    {
        eaten_.assign(picture_.alpha.size(), 0);
        if (options_.is_skeleton)
            for (std::size_t i = 0; i < picture_.alpha.size(); ++i)
                picture_.alpha[i] *= picture_.protection[i];
        for (int i = 0; i < options_.larvae.count; ++i)
            eat_with(i);
    }

    double protection_at(Vec2 const& at) const
    {
        int const x = static_cast<int>(at.x());
        int const y = static_cast<int>(at.y());
        bool const is_inside = at.x() >= 0 && at.y() >= 0 && x < side_ && y < side_;
        return is_inside ? double(picture_.protection[index(x, y)]) : 0;
    }
    bool is_on_leaf(Vec2 const& at) const
    {
        int const x = static_cast<int>(at.x());
        int const y = static_cast<int>(at.y());
        return at.x() >= 0 && at.y() >= 0 && x < side_ && y < side_
            && picture_.coverage[index(x, y)] > 0.5f;
    }
    bool is_free(Vec2 const& at, double radius) const
    {
        for (int i = 0; i < 8; ++i) {
            double const angle = 0.25 * std::numbers::pi * i;
            Vec2 const beside = at + 0.5 * radius * Vec2(std::cos(angle), std::sin(angle));
            if (protection_at(beside) > 0.5)
                return false;
        }
        return protection_at(at) < 0.5;
    }

    // On the margin, seen from a random place in a random direction; or that place itself.
    Vec2 find_start(Random& random) const
    {
        Vec2 at(0, 0);
        for (int i = 0; i < 200 && (!is_on_leaf(at) || !is_free(at, 0.04 * side_)); ++i)
            at = { random.uniform(0, side_), random.uniform(0, side_) };
        double const angle = random.uniform(0, 2 * std::numbers::pi);
        if (random.uniform() < 0.7)
            while (is_on_leaf(at))
                at += 0.5 * Vec2(std::cos(angle), std::sin(angle));
        return at;
    }

    void eat_with(int number)
    {
        auto const& larvae = options_.larvae;
        Random random({ .seed = options_.seed,
                        .stream = kLarvaStream,
                        .substream = static_cast<std::uint32_t>(number) });
        Vec2 at = find_start(random);
        double heading = random.uniform(0, 2 * std::numbers::pi);
        double const radius
            = random.uniform(larvae.least_radius, larvae.most_radius) * double(side_);
        int const bites
            = static_cast<int>(random.uniform(larvae.least_bites, larvae.most_bites + 1));
        for (int i = 0; i < bites; ++i) {
            bite(at, radius, hash(options_.seed, number, i));
            heading += radians(25) * random.normal();
            bool is_found = false;
            for (int turn = 0; turn <= 16 && !is_found; ++turn) {
                double const aside = radians(20) * ((turn + 1) / 2) * (turn % 2 == 0 ? 1 : -1);
                Vec2 const next = at
                    + 0.7 * radius * Vec2(std::cos(heading + aside), std::sin(heading + aside));
                if (!is_free(next, radius) || (i > 0 && !is_on_leaf(next)))
                    continue;
                is_found = true;
                at = next;
                heading += aside;
            }
            if (!is_found)
                return;
        }
    }

    void bite(Vec2 const& at, double radius, double wobble)
    {
        double const far = 1.2 * radius + rim() + 1;
        int const x0 = std::clamp(static_cast<int>(at.x() - far), 0, side_);
        int const x1 = std::clamp(static_cast<int>(at.x() + far) + 1, 0, side_);
        int const y0 = std::clamp(static_cast<int>(at.y() - far), 0, side_);
        int const y1 = std::clamp(static_cast<int>(at.y() + far) + 1, 0, side_);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                Vec2 const away = Vec2(x + 0.5, y + 0.5) - at;
                double const angle = std::atan2(away.y(), away.x());
                double const edge = radius
                    * (1 + 0.1 * std::sin(3 * angle + 7 * wobble) + 0.06 * std::sin(7 * angle));
                double const disc = std::clamp(edge - away.norm() + 0.5, 0.0, 1.0);
                auto const i = index(x, y);
                double const kept = 1 - disc * (1 - double(picture_.protection[i]));
                picture_.alpha[i] = std::min(
                    picture_.alpha[i], static_cast<float>(double(picture_.coverage[i]) * kept));
                double const near = std::clamp((edge + rim() - away.norm()) / rim(), 0.0, 1.0);
                eaten_[i] = std::max(eaten_[i], static_cast<float>(near));
            }
    }

    double rim() const { return std::max(1.5, 0.008 * side_); }

    // Only what hangs together with the stalk stays.
    void keep_connected()
    {
        if (options_.larvae.count == 0 && !options_.is_skeleton)
            return;
        std::vector<bool> is_kept(picture_.alpha.size());
        std::vector<std::size_t> pending;
        auto const visit = [&](int x, int y) {
            if (x < 0 || y < 0 || x >= side_ || y >= side_)
                return;
            auto const i = index(x, y);
            if (is_kept[i] || picture_.alpha[i] <= 0)
                return;
            is_kept[i] = true;
            // What is as good as eaten stays as an edge, and holds nothing.
            if (picture_.alpha[i] >= 0.5f * picture_.coverage[i])
                pending.push_back(i);
        };
        int const near = std::max(2, side_ / 64);
        auto const x0 = static_cast<int>(base_.x());
        auto const y0 = static_cast<int>(base_.y());
        for (int y = y0 - near; y <= y0 + near; ++y)
            for (int x = x0 - near; x <= x0 + near; ++x)
                visit(x, y);
        while (!pending.empty()) {
            auto const i = pending.back();
            pending.pop_back();
            int const x = static_cast<int>(i) % side_;
            int const y = static_cast<int>(i) / side_;
            visit(x - 1, y);
            visit(x + 1, y);
            visit(x, y - 1);
            visit(x, y + 1);
        }
        for (std::size_t i = 0; i < is_kept.size(); ++i)
            if (!is_kept[i])
                picture_.alpha[i] = 0;
    }

    Vec2 place(int x, int y) const { return Vec2(x + 0.5, y + 0.5) / side_; }

    // Pixels of the leaf, and those so near that a filter or a normal may look at them.
    std::vector<bool> near_leaf() const
    {
        constexpr int kNear = 4;
        std::vector<bool> in_rows(picture_.coverage.size());
        std::vector<bool> made(picture_.coverage.size());
        for (int y = 0; y < side_; ++y)
            for (int x = 0; x < side_; ++x)
                if (picture_.coverage[index(x, y)] > 0)
                    for (int i = std::max(0, x - kNear); i <= std::min(side_ - 1, x + kNear); ++i)
                        in_rows[index(i, y)] = true;
        for (int y = 0; y < side_; ++y)
            for (int x = 0; x < side_; ++x)
                if (in_rows[index(x, y)])
                    for (int i = std::max(0, y - kNear); i <= std::min(side_ - 1, y + kNear); ++i)
                        made[index(x, i)] = true;
        return made;
    }

    // Veins stand out, the limb between them is vaulted, and small veins make a closed net.
    void find_heights()
    {
        height_.resize(picture_.coverage.size());
        net_.resize(picture_.coverage.size());
        auto const is_near = near_leaf();
        double const density = std::clamp(0.28 * side_ / radius_, 12.0, 70.0);
        parallel_for(static_cast<std::size_t>(side_), 16, [&](std::size_t begin, std::size_t end) {
            for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
                for (int x = 0; x < side_; ++x) {
                    auto const i = index(x, y);
                    if (!is_near[i]) // The net takes most of the time, and nobody sees it there.
                        continue;
                    Vec2 const at = place(x, y);
                    Vec2 const bent = at
                        + 0.006
                            * Vec2(value_noise(options_.seed + 31, 30 * at),
                                   value_noise(options_.seed + 37, 30 * at));
                    auto const coarse = cells(options_.seed + 41, density * bent);
                    auto const fine = cells(options_.seed + 43, 2.7 * density * bent);
                    net_[i] = static_cast<float>(std::max(1 - smooth(coarse.border / 0.16),
                                                          0.5 * (1 - smooth(fine.border / 0.22))));
                    double const d = double(picture_.closeness[i]);
                    height_[i] = static_cast<float>(
                        0.5 * double(profile_[i]) - 0.25 * std::exp(-d / 0.35)
                        + 0.1 * double(net_[i]) + 0.03 * cloud(options_.seed + 51, 60 * at));
                }
        });
    }

    float height_at(int x, int y) const
    {
        return height_[index(std::clamp(x, 0, side_ - 1), std::clamp(y, 0, side_ - 1))];
    }

    void paint_pixel(int x, int y)
    {
        auto const i = index(x, y);
        Vec2 const at = place(x, y);
        double const d = double(picture_.closeness[i]);
        double const v = double(profile_[i]);
        double const patches = cloud(options_.seed + kNoiseStream, 7 * at);
        double const m = age_at(options_.age, d, smooth(1.6 * patches - 0.3), options_);
        picture_.age[i] = static_cast<float>(m);
        Vec3 const young = linear(options_.young);
        Vec3 const old = linear(options_.old);
        Vec3 color = mix(young, old, m);
        // Each leaf is a little mottled, and paler along its veins.
        double const mottle = 0.82 + 0.36 * cloud(options_.seed + 61, 24 * at) + 0.08 * (d - 0.5);
        color *= mottle;
        Vec3 const tint = mix(color, linear({ 0.90, 0.91, 0.66 }), 0.55);
        double const order_fade = vein_order_[i] <= 1 ? 0.75 : 0.5;
        color = mix(color, tint, order_fade * v + (1 - v) * 0.14 * double(net_[i]));
        color = with_damage(color, i, at);
        paint_relief(x, y, v);
        picture_.color[i] = { srgb_byte(color.x()), srgb_byte(color.y()), srgb_byte(color.z()),
                              byte(double(picture_.alpha[i])) };
    }

    Vec3 with_damage(Vec3 color, std::size_t i, Vec2 const& at) const
    {
        if (options_.spots > 0) {
            auto const spot = cells(options_.seed + 71, 16 * at);
            double const radius = 0.12
                + 0.25 * hash(options_.seed + 73, static_cast<std::int64_t>(1e6 * spot.number), 0);
            if (spot.number < options_.spots) {
                double const inside = smooth((radius - spot.distance) / 0.08 + 0.5);
                double const ring = smooth((0.7 * radius - spot.distance) / 0.05 + 0.5);
                color = mix(color, linear({ 0.26, 0.13, 0.06 }), 0.85 * inside);
                color = mix(color, linear({ 0.52, 0.38, 0.22 }), 0.7 * ring);
            }
        }
        if (options_.is_skeleton)
            color = mix(color, linear({ 0.55, 0.42, 0.26 }), 0.8);
        return mix(color, linear({ 0.36, 0.21, 0.09 }), 0.7 * double(eaten_[i]));
    }

    void paint_relief(int x, int y, double v)
    {
        auto const i = index(x, y);
        double const strength = 0.006 * side_;
        double const du = 0.5 * double(height_at(x + 1, y) - height_at(x - 1, y));
        double const dv = 0.5 * double(height_at(x, y - 1) - height_at(x, y + 1));
        Vec3 const n = Vec3(-strength * du, -strength * dv, 1).normalized();
        picture_.normal[i]
            = { byte(0.5 + 0.5 * n.x()), byte(0.5 + 0.5 * n.y()), byte(0.5 + 0.5 * n.z()) };
        double const aged = double(picture_.age[i]);
        double const rough
            = std::clamp(0.42 + 0.2 * aged + 0.08 * double(net_[i]) - 0.05 * v, 0.35, 0.7);
        double const occlusion
            = 1 - 0.25 * std::exp(-double(picture_.closeness[i]) / 0.2) * (1 - v);
        picture_.roughness[i] = { byte(occlusion), byte(rough), 0 };
        picture_.translucency[i]
            = byte((0.55 - 0.2 * aged) * (1 - 0.75 * v) * (1 - 0.2 * double(net_[i])));
    }

    PaintOptions const& options_;
    PictureFrame frame_;
    int side_;
    LeafPicture picture_;
    std::vector<Leaf::Vein> veins_; // In pixels.
    Vec2 base_ = Vec2::Zero();
    double radius_ = 1; // The distance at which D is 1.
    std::vector<float> profile_;
    std::vector<std::uint8_t> vein_order_;
    std::vector<float> eaten_;
    std::vector<float> height_;
    std::vector<float> net_;
};

} // namespace

PictureFrame::PictureFrame(LeafTriangles const& leaf, int side)
{
    Eigen::AlignedBox2d box;
    for (auto const& flat : leaf.flat)
        box.extend(flat);
    double const longer = leaf.flat.empty() ? 0 : box.sizes().maxCoeff();
    if (!(longer > 0))
        return;
    scale = (1 - 2 * kMargin) * side / longer;
    origin = { box.center().x(), box.min().y() };
    x0 = 0.5 * side;
    y0 = (1 - kMargin) * side;
}

double age_at(double age, double closeness, double noise, PaintOptions const& options)
{
    double const x = age * (1 + options.near_veins + options.noise) - options.near_veins * closeness
        - options.noise * noise;
    return smooth(x);
}

LeafPicture paint_leaf(Leaf const& leaf, LeafTriangles const& triangles,
                       PaintOptions const& options)
{
    return Painter(leaf, triangles, options).paint();
}

} // namespace tractus::leaf
