#include "engine/export/bark_pictures.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/export/bark_style.h"
#include "engine/export/gltf_material.h"
#include "engine/export/png.h"
#include "engine/export/relief_tile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

namespace tractus::exports {

namespace {

// Bark that is old in places, between those of limbs and of old trunks.
class HalfOldBark {
public:
    explicit HalfOldBark(BarkKind kind)
        : young_(bark_style(kind, BarkAge::Young))
        , old_(bark_style(kind, BarkAge::Old))
    {
    }

    double depth() const { return std::max(young_.depth, old_.depth); }

    BarkPoint at(double u, double v) const
    {
        constexpr std::uint32_t kLayer = 2001;
        double const place = tile_turbulence(u, v, { 4, 3 }, 4, kLayer);
        double const share = std::clamp((place - 0.42) / 0.16, 0.0, 1.0);
        auto const young = bark_point(young_, u, v);
        auto const old = bark_point(old_, u, v);
        return { .height = (1 - share) * (young.height * young_.depth / depth() + 0.3)
                     + share * old.height * old_.depth / depth(),
                 .color = young.color + share * (old.color - young.color),
                 .roughness = young.roughness + share * (old.roughness - young.roughness) };
    }

private:
    BarkStyle young_;
    BarkStyle old_;
};

std::uint8_t byte_from(double value)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

class BarkPainter {
public:
    BarkPainter(Bark const& bark, int side)
        : side_(side)
        , depth_(0)
    {
        points_.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        if (bark.age == BarkAge::Half) {
            HalfOldBark const mixed(bark.kind);
            depth_ = mixed.depth();
            sample([&](double u, double v) { return mixed.at(u, v); });
        } else {
            auto const style = bark_style(bark.kind, bark.age);
            depth_ = style.depth;
            sample([&](double u, double v) { return bark_point(style, u, v); });
        }
    }

    BarkPictures run() const
    {
        std::vector<double> heights;
        heights.reserve(points_.size());
        Vec3 sum = Vec3::Zero();
        for (auto const& point : points_) {
            heights.push_back(point.height);
            for (int k = 0; k < 3; ++k)
                sum[k] += linear_from_srgb(point.color[k]);
        }
        ReliefTile const relief(side_, std::move(heights));
        BarkPictures made;
        made.mean_color = sum / static_cast<double>(points_.size());
        made.color = picture([&](int column, int row) { return point(column, row).color; });
        made.normals
            = picture([&](int column, int row) { return relief.normal(column, row, depth_); });
        made.occlusion_roughness = picture([&](int column, int row) {
            return Vec3(relief.openness(column, row), point(column, row).roughness, 0);
        });
        return made;
    }

private:
    BarkPoint const& point(int column, int row) const
    {
        return points_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_)
                       + static_cast<std::size_t>(column)];
    }

    template<typename PointAt> void sample(PointAt const& point_at)
    {
        constexpr std::size_t kGrain = 8;
        auto const side = static_cast<std::size_t>(side_);
        parallel_for(side, kGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row)
                for (std::size_t column = 0; column < side; ++column)
                    points_[row * side + column]
                        = point_at((static_cast<double>(column) + 0.5) / side_,
                                   (static_cast<double>(row) + 0.5) / side_);
        });
    }

    template<typename ColorAt> TextureSlot picture(ColorAt const& color_at) const
    {
        std::vector<std::uint8_t> pixels;
        pixels.reserve(3 * points_.size());
        for (int row = 0; row < side_; ++row)
            for (int column = 0; column < side_; ++column)
                for (double const value : Vec3(color_at(column, row)))
                    pixels.push_back(byte_from(value));
        return std::make_shared<TexturePicture const>(
            TexturePicture { png_bytes({ side_, side_, 3, pixels, PngPicture::Packing::Fast }),
                             TexturePicture::Edges::Repeat });
    }

    int side_;
    double depth_; // Of the relief, as a share of the circumference.
    std::vector<BarkPoint> points_;
};

} // namespace

BarkPictures const& bark_pictures(Bark const& bark, int side_px)
{
    CHECK(bark.kind != BarkKind::Furrowed);
    CHECK(side_px >= 16 && side_px <= kMaxBarkPicture_px);
    using Key = std::tuple<BarkKind, BarkAge, int>;
    static std::mutex mutex;
    static std::map<Key, BarkPictures> known;
    Key const key { bark.kind, bark.age, side_px };
    {
        std::lock_guard const lock(mutex);
        if (auto const found = known.find(key); found != known.end())
            return found->second;
    }
    // Painted without the lock, since a thread that waits for others may meanwhile do their work
    // and need the lock, too. If two threads paint the same bark, the first one's pictures stay.
    auto made = BarkPainter(bark, side_px).run();
    std::lock_guard const lock(mutex);
    return known.emplace(key, std::move(made)).first->second;
}

} // namespace tractus::exports
