#include "engine/methods/silhouettes/picture_crown.h"

#include "engine/methods/silhouettes/plane.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr double kMinArea = 0.006; // Smallest area of a crown, as a share of the picture's area.
constexpr double kMaxArea = 0.6;

// A boolean for each pixel of a picture.
struct Mask {
    int width;
    int height;
    std::vector<char> in;

    Mask(int w, int h)
        : width(w)
        , height(h)
        , in(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0)
    {
    }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
            + static_cast<std::size_t>(x);
    }
    bool at(int x, int y) const { return holds(x, y) && in[index(x, y)] != 0; }
};

constexpr std::array<std::pair<int, int>, 4> kBeside {
    { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } }
};

// CIE L*a*b* (D65), in which distances approximate perceived colour differences.
Vec3f lab_of(Vec3f const& srgb)
{
    Vec3f linear;
    for (int i = 0; i < 3; ++i)
        linear[i]
            = srgb[i] <= 0.04045f ? srgb[i] / 12.92f : std::pow((srgb[i] + 0.055f) / 1.055f, 2.4f);
    Eigen::Matrix3f to_xyz;
    to_xyz << 0.4339f, 0.3762f, 0.1899f, 0.2126f, 0.7152f, 0.0722f, 0.0177f, 0.1095f, 0.8728f;
    Vec3f const xyz = to_xyz * linear; // The colour in XYZ, relative to the white point.
    auto const f = [](float t) { return t > 0.008856f ? std::cbrt(t) : 7.787f * t + 0.13793f; };
    float const y = f(xyz.y());
    return { 116 * y - 16, 500 * (f(xyz.x()) - y), 200 * (y - f(xyz.z())) };
}

// Box blur with `reach` pixels to each side.
std::vector<Vec3f> blurred(std::vector<Vec3f> const& pixels, Mask const& size, int reach)
{
    std::vector<Vec3f> result(pixels.size(), Vec3f::Zero());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            Vec3f sum = Vec3f::Zero();
            float count = 0;
            for (int v = std::max(0, y - reach); v <= std::min(size.height - 1, y + reach); ++v)
                for (int u = std::max(0, x - reach); u <= std::min(size.width - 1, x + reach);
                     ++u) {
                    sum += pixels[size.index(u, v)];
                    count += 1;
                }
            result[size.index(x, y)] = sum / count;
        }
    return result;
}

// Distance of each pixel's colour from the colours around the seed point, relative to their
// covariance (Mahalanobis). Lightness counts less, because crowns have shadows.
std::vector<float> distances_from(std::vector<Vec3f> const& colors, Mask const& size, int px,
                                  int py)
{
    int const reach = std::max(2, size.width / 30);
    Vec3f mean = Vec3f::Zero();
    float count = 0;
    auto const each = [&](auto const& use) {
        for (int y = py - reach; y <= py + reach; ++y)
            for (int x = px - reach; x <= px + reach; ++x)
                if (size.holds(x, y))
                    use(colors[size.index(x, y)]);
    };
    each([&](Vec3f const& color) { mean += color, count += 1; });
    mean /= count;
    // Minimum covariance, added to the measured one.
    Eigen::Matrix3f spread = Eigen::Vector3f(250, 12, 12).asDiagonal();
    each(
        [&](Vec3f const& color) { spread += (color - mean) * (color - mean).transpose() / count; });
    Eigen::LLT<Eigen::Matrix3f> const root(spread);
    std::vector<float> distances;
    distances.reserve(colors.size());
    for (auto const& color : colors)
        distances.push_back(root.matrixL().solve(color - mean).norm());
    return distances;
}

// Pixels in the order in which a flood from the seed point reaches them, each with the level that
// the flood needs to reach it.
struct Flood {
    std::vector<std::size_t> order {};
    std::vector<float> levels {};
};

Flood flood_from(std::vector<float> const& distances, Mask const& size, int px, int py)
{
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    std::vector<char> seen(distances.size(), 0);
    Flood flood;
    auto const start = size.index(px, py);
    waiting.emplace(distances[start], start);
    seen[start] = 1;
    float level = 0;
    while (!waiting.empty()) {
        auto const [distance, pixel] = waiting.top();
        waiting.pop();
        level = std::max(level, distance);
        flood.order.push_back(pixel);
        flood.levels.push_back(level);
        int const x = static_cast<int>(pixel % static_cast<std::size_t>(size.width));
        int const y = static_cast<int>(pixel / static_cast<std::size_t>(size.width));
        for (auto const& [dx, dy] : kBeside) {
            if (!size.holds(x + dx, y + dy) || seen[size.index(x + dx, y + dy)])
                continue;
            seen[size.index(x + dx, y + dy)] = 1;
            waiting.emplace(distances[size.index(x + dx, y + dy)], size.index(x + dx, y + dy));
        }
    }
    return flood;
}

// Number of pixels after which the flood would touch more than one side of the picture, which means
// that it has leaked into sky or ground.
std::size_t most_before_sides(Flood const& flood, Mask const& size)
{
    // Length of contact that counts as touching a side, as a share of the side's length.
    constexpr double kSome = 0.1;
    std::array<double, 4> counts {};
    for (std::size_t i = 0; i < flood.order.size(); ++i) {
        int const x = static_cast<int>(flood.order[i] % static_cast<std::size_t>(size.width));
        int const y = static_cast<int>(flood.order[i] / static_cast<std::size_t>(size.width));
        counts[0] += x == 0;
        counts[1] += x == size.width - 1;
        counts[2] += y == 0;
        counts[3] += y == size.height - 1;
        int const sides = (counts[0] > kSome * size.height) + (counts[1] > kSome * size.height)
            + (counts[2] > kSome * size.width) + (counts[3] > kSome * size.width);
        if (sides > 1)
            return i;
    }
    return flood.order.size();
}

// Size, in pixels, at which the flood grows least when its level changes by 12 % up and down; of
// several nearly equally steady sizes, the largest. No value if the flood always grows fast.
std::optional<std::size_t> steadiest(Flood const& flood, Mask const& size)
{
    constexpr float kRise = 0.12f;
    // Maximum growth, as a share of the flood's area, at which a flood counts as stable.
    constexpr double kRest = 0.9;
    constexpr double kLarge = 0.3;
    auto const all = static_cast<double>(flood.order.size());
    auto const most = std::min(kMaxArea * all, static_cast<double>(most_before_sides(flood, size)));
    auto const area_at = [&](float level) {
        return static_cast<double>(std::upper_bound(flood.levels.begin(), flood.levels.end(), level)
                                   - flood.levels.begin());
    };
    std::optional<std::size_t> best;
    double least = 1e300;
    for (float level = 0.5f; level < flood.levels.back(); level *= 1.04f) {
        double const area = area_at(level);
        if (area < kMinArea * all || area > most)
            continue;
        double const growth = (area_at(level * (1 + kRise)) - area_at(level / (1 + kRise))) / area;
        double const unsteady = growth / std::pow(area / (kMaxArea * all), kLarge);
        if (growth < kRest && unsteady < least) {
            least = unsteady;
            best = static_cast<std::size_t>(area);
        }
    }
    return best;
}

// Dilates the mask by `reach` pixels if `in` is true; erodes it if `in` is false.
Mask grown(Mask const& mask, int reach, bool in)
{
    Mask result = mask;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            if (mask.at(x, y) != in)
                continue;
            for (int v = -reach; v <= reach; ++v)
                for (int u = -reach; u <= reach; ++u)
                    if (u * u + v * v <= reach * reach && mask.holds(x + u, y + v))
                        result.in[mask.index(x + u, y + v)] = in;
        }
    return result;
}

// The connected component of pixels equal to `in` that contains (px, py).
Mask part_with(Mask const& mask, int px, int py, bool in)
{
    Mask part(mask.width, mask.height);
    std::vector<std::pair<int, int>> waiting { { px, py } };
    while (!waiting.empty()) {
        auto const [x, y] = waiting.back();
        waiting.pop_back();
        if (!mask.holds(x, y) || mask.at(x, y) != in || part.at(x, y))
            continue;
        part.in[mask.index(x, y)] = 1;
        for (auto const& [dx, dy] : kBeside)
            waiting.emplace_back(x + dx, y + dy);
    }
    return part;
}

// Adds a border of unset pixels, so that the region's edge is closed.
Mask framed(Mask const& mask)
{
    Mask result(mask.width + 2, mask.height + 2);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            result.in[result.index(x + 1, y + 1)] = mask.at(x, y);
    return result;
}

// The largest connected part of a mask, without holes and without parts thinner than twice `thin`;
// gaps narrower than twice `gap` are closed.
std::optional<Mask> solid_part(Mask mask, int gap, int thin)
{
    mask = grown(grown(mask, gap, true), gap, false);
    mask = framed(mask);
    auto const outside = part_with(mask, 0, 0, false);
    for (std::size_t i = 0; i < mask.in.size(); ++i)
        mask.in[i] = !outside.in[i];
    // Grows back one pixel more than was eroded, because the flood stops a pixel early where
    // colours mix at the edge.
    mask = grown(grown(mask, thin, false), thin + 1, true);
    std::optional<Mask> largest;
    std::ptrdiff_t most = 0;
    Mask left = mask;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            if (!left.at(x, y))
                continue;
            auto part = part_with(left, x, y, true);
            for (std::size_t i = 0; i < left.in.size(); ++i)
                left.in[i] = left.in[i] && !part.in[i];
            auto const area = std::count(part.in.begin(), part.in.end(), 1);
            if (area > most) {
                most = area;
                largest = std::move(part);
            }
        }
    return largest;
}

// Traces the region's edge along pixel corners, counter-clockwise with y up. Takes a mask from
// framed() and returns coordinates of the original picture.
std::vector<Vec2> edge_of(Mask const& mask)
{
    int x = 0;
    int y = 0;
    while (!mask.at(x, y))
        if (++x == mask.width)
            x = 0, ++y;
    std::vector<Vec2> edge;
    int const start_x = x;
    int const start_y = y;
    // Starts down from the upper left corner of the first pixel, with the region on the left.
    int dx = 0;
    int dy = 1;
    do {
        edge.emplace_back(x - 1, mask.height - 1 - y);
        x += dx;
        y += dy;
        // Returns true if the pixel ahead on one side of the direction (dx, dy) belongs to the
        // region. `side`: 1 for left, -1 for right, as seen in the picture.
        auto const ahead = [&](int side) {
            int const u = x + (dx > 0 ? 0 : dx < 0 ? -1 : side * dy > 0 ? 0 : -1);
            int const v = y + (dy > 0 ? 0 : dy < 0 ? -1 : side * dx > 0 ? -1 : 0);
            return mask.at(u, v);
        };
        if (!ahead(1)) { // Turns left.
            std::swap(dx, dy);
            dy = -dy;
        } else if (ahead(-1)) { // Turns right.
            std::swap(dx, dy);
            dx = -dx;
        }
    } while (x != start_x || y != start_y);
    return edge;
}

std::vector<Vec2> smooth(std::vector<Vec2> const& edge, double deviation)
{
    constexpr std::size_t kPoints = 200;
    auto const even = resampled_outline(edge, 4 * kPoints);
    double const step = (even[1] - even[0]).norm();
    int const reach = static_cast<int>(std::ceil(3 * deviation / std::max(step, 1e-9)));
    auto const n = static_cast<int>(even.size());
    std::vector<Vec2> result;
    for (int i = 0; i < n; ++i) {
        Vec2 sum = Vec2::Zero();
        double weights = 0;
        for (int k = -std::min(reach, n / 2); k <= std::min(reach, n / 2); ++k) {
            double const x = k * step / deviation;
            double const weight = std::exp(-0.5 * x * x);
            sum += weight * even[static_cast<std::size_t>(((i + k) % n + n) % n)];
            weights += weight;
        }
        result.emplace_back(sum / weights);
    }
    return resampled_outline(result, kPoints);
}

} // namespace

Result<std::vector<Vec2>> find_crown_in_picture(PictureGrid const& picture, Vec2 const& place)
{
    auto const nothing = [] {
        return fail(Fault::User,
                    "no crown stands out there in the picture: touch another place in it, or draw "
                    "around it");
    };
    Mask region(picture.width, picture.height);
    int const x = static_cast<int>(std::floor(place.x()));
    int const y = picture.height - 1 - static_cast<int>(std::floor(place.y()));
    if (!place.allFinite() || !region.holds(x, y))
        return fail(Fault::User, "the touch is beside the picture: touch a crown in it");
    std::vector<Vec3f> colors;
    for (auto const& pixel : picture.pixels)
        colors.push_back(lab_of(pixel));
    colors = blurred(colors, region, 2);
    auto const flood = flood_from(distances_from(colors, region, x, y), region, x, y);
    auto const area = steadiest(flood, region);
    if (!area)
        return nothing();
    for (std::size_t i = 0; i < *area; ++i)
        region.in[flood.order[i]] = 1;
    auto const part
        = solid_part(region, std::max(2, picture.width / 50), std::max(1, picture.width / 75));
    if (!part)
        return nothing();
    return smooth(edge_of(*part), std::max(1.0, picture.width / 150.0));
}

} // namespace tractus::silhouette
