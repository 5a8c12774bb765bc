#include "engine/export/bark_pictures.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/export/bark_style.h"
#include "engine/export/gltf_material.h"
#include "engine/export/png.h"
#include "engine/export/relief_tile.h"

#include <algorithm>
#include <array>
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
        : young_style_(bark_style(kind, BarkAge::Young))
        , old_style_(bark_style(kind, BarkAge::Old))
        , young_(young_style_)
        , old_(old_style_)
    {
    }

    float depth() const { return std::max(young_style_.depth, old_style_.depth); }

    BarkPoint at(float u, float v) const
    {
        float const share = std::clamp((places_.at(u, v) - 0.42F) / 0.16F, 0.0F, 1.0F);
        if (share <= 0)
            return young_at(u, v);
        if (share >= 1)
            return old_at(u, v);
        auto const young = young_at(u, v);
        auto const old = old_at(u, v);
        return { .height = young.height + share * (old.height - young.height),
                 .color = young.color + share * (old.color - young.color),
                 .roughness = young.roughness + share * (old.roughness - young.roughness) };
    }

private:
    // Young bark lies between the bottom of the furrows and the ridges of old bark.
    BarkPoint young_at(float u, float v) const
    {
        auto point = young_.at(u, v);
        point.height = point.height * young_style_.depth / depth() + 0.3F;
        return point;
    }

    BarkPoint old_at(float u, float v) const
    {
        auto point = old_.at(u, v);
        point.height *= old_style_.depth / depth();
        return point;
    }

    BarkStyle young_style_;
    BarkStyle old_style_;
    BarkField young_;
    BarkField old_;
    TileTurbulence places_ { { 4, 3 }, 4, 2001 };
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
            sample(mixed);
        } else {
            auto const style = bark_style(bark.kind, bark.age);
            depth_ = style.depth;
            sample(BarkField(style));
        }
    }

    BarkPictures run() const
    {
        std::vector<double> heights;
        heights.reserve(points_.size());
        for (auto const& point : points_)
            heights.push_back(double { point.height });
        ReliefTile const relief(side_, std::move(heights));
        BarkPictures made;
        made.mean_color = mean_color();
        made.color = picture(
            [&](int column, int row) { return point(column, row).color.cast<double>().eval(); });
        made.normals = picture(
            [&](int column, int row) { return relief.normal(column, row, double { depth_ }); });
        made.occlusion_roughness = picture([&](int column, int row) {
            return Vec3(relief.openness(column, row), double { point(column, row).roughness }, 0);
        });
        return made;
    }

private:
    // The mean in linear light, of colours rounded as in the picture.
    Vec3 mean_color() const
    {
        std::array<std::array<std::uint32_t, 256>, 3> counts {};
        for (auto const& point : points_)
            for (std::size_t k = 0; k < counts.size(); ++k)
                ++counts[k][byte_from(double { point.color[static_cast<Eigen::Index>(k)] })];
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < counts.size(); ++k)
            for (std::size_t level = 0; level < counts[k].size(); ++level)
                sum[static_cast<Eigen::Index>(k)]
                    += counts[k][level] * linear_from_srgb(static_cast<double>(level) / 255);
        return sum / static_cast<double>(points_.size());
    }

    BarkPoint const& point(int column, int row) const
    {
        return points_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_)
                       + static_cast<std::size_t>(column)];
    }

    // Samples a field: BarkField or HalfOldBark.
    template<typename Field> void sample(Field const& field)
    {
        constexpr std::size_t kRowsAtOnce = 8;
        auto const side = static_cast<std::size_t>(side_);
        parallel_for(side, kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row)
                for (std::size_t column = 0; column < side; ++column)
                    points_[row * side + column]
                        = field.at((static_cast<float>(column) + 0.5F) / static_cast<float>(side_),
                                   (static_cast<float>(row) + 0.5F) / static_cast<float>(side_));
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
    float depth_; // Of the relief, as a share of the circumference.
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
