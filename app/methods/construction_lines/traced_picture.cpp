#include "app/methods/construction_lines/traced_picture.h"

#include "app/render/image.h"
#include "app/render/read_picture.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

constexpr int kNarrowest = 32; // Minimum width of a leaf's picture, in pixels.

// Maps the surface of a drawn leaf, seen from above, to the tablet.
class LeafOnTablet {
public:
    static Result<LeafOnTablet> create(SketchOrgan const& organ, SheetPlacement const& sheet)
    {
        auto const views = TRY(views_of(organ));
        LeafOnTablet leaf(sheet);
        leaf.patches_ = TRY(organ_surface(views));
        leaf.base_ = (views.left.front() + views.right.front()) / 2;
        Vec2 const tip = (views.left.back() + views.right.back()) / 2;
        leaf.along_ = (tip - leaf.base_).normalized();
        return leaf;
    }

    // Position on the tablet of a point of the surface: `s` is 0 at the base and 1 at the tip, `t`
    // is 0 at the left edge and 1 at the right edge.
    Vec2 at(double s, double t) const
    {
        auto const piece = [](double share, int count) {
            return std::clamp(static_cast<int>(share * count), 0, count - 1);
        };
        int const row = piece(s, kAlong);
        int const column = piece(t, kAcross);
        auto const& patch = patches_[static_cast<std::size_t>(row * kAcross + column)];
        Vec3 const place = patch.at(s * kAlong - row, t * kAcross - column);
        Vec2 const right(along_.y(), -along_.x());
        return sheet_.on_tablet(base_ + place.x() * right + place.y() * along_);
    }

    // The leaf's greatest width as a multiple of its length.
    double slenderness() const
    {
        double breadth = 0;
        for (int row = 0; row <= kAlong; ++row) {
            double const s = static_cast<double>(row) / kAlong;
            breadth = std::max(breadth, (at(s, 1) - at(s, 0)).norm());
        }
        return breadth / std::max((at(1, 0.5) - at(0, 0.5)).norm(), 1e-9);
    }

private:
    explicit LeafOnTablet(SheetPlacement const& sheet)
        : sheet_(sheet)
    {
    }

    SheetPlacement sheet_;
    std::vector<BezierPatch> patches_ {};
    Vec2 base_ = Vec2::Zero();
    Vec2 along_ = Vec2::UnitY();
};

// The image behind the sheet, and its place on the tablet.
class LaidImage {
public:
    LaidImage(render::Image image, scene::PicturePlace const& place)
        : image_(std::move(image))
        , place_(place)
        , pixels_per_mm_(image_.width() / place.width_mm)
    {
    }

    // Position in the image of a place on the tablet, in pixels from the image's upper left corner.
    Vec2 pixel_of(Vec2 const& tablet_mm) const
    {
        double const turn_rad = radians(place_.turn_deg);
        Vec2 const off = pixels_per_mm_ * (tablet_mm - Vec2(place_.x_mm, place_.y_mm));
        Vec2 const right(std::cos(turn_rad), std::sin(turn_rad));
        Vec2 const up(-right.y(), right.x());
        return { image_.width() / 2.0 + off.dot(right), image_.height() / 2.0 - off.dot(up) };
    }

    bool contains(Vec2 const& pixel) const
    {
        return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < image_.width()
            && pixel.y() < image_.height();
    }

    // Returns the colour of the pixel at this position. For a position beyond the image's border,
    // returns the colour of the nearest pixel.
    render::Color color_at(Vec2 const& pixel) const
    {
        auto const nearest = [](double at, int count) {
            return static_cast<int>(std::clamp(std::floor(at), 0.0, count - 1.0));
        };
        return image_.at(nearest(pixel.x(), image_.width()), nearest(pixel.y(), image_.height()));
    }

private:
    render::Image image_;
    scene::PicturePlace place_;
    double pixels_per_mm_;
};

// Mean of colours, weighted by alpha.
class ColorMean {
public:
    void add(render::Color const& color)
    {
        sum_ += color.alpha * Vec3(color.red, color.green, color.blue);
        alpha_ += color.alpha;
        ++count_;
    }

    render::Color mean() const
    {
        if (alpha_ <= 0)
            return { 0, 0, 0, 0 };
        auto const byte
            = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
        Vec3 const color = sum_ / alpha_;
        return { byte(color.x()), byte(color.y()), byte(color.z()), byte(alpha_ / count_) };
    }

private:
    Vec3 sum_ = Vec3::Zero();
    double alpha_ = 0;
    int count_ = 0;
};

// Number of samples along each side of a pixel of the leaf's picture. It is chosen so that few
// pixels of the image are skipped.
int samples_a_side(LeafOnTablet const& leaf, LaidImage const& image)
{
    constexpr double kMax = 4; // An image so fine that it needs more samples is assumed to be even.
    Vec2 const way = image.pixel_of(leaf.at(1, 0.5)) - image.pixel_of(leaf.at(0, 0.5));
    return static_cast<int>(std::clamp(std::ceil(way.norm() / kLeafPictureLength), 1.0, kMax));
}

} // namespace

Result<std::string> traced_picture(SketchOrgan const& organ, SheetPlacement const& sheet,
                                   scene::BackPicture const& picture)
{
    auto const leaf = TRY(LeafOnTablet::create(organ, sheet));
    LaidImage const image(TRY(render::read_picture(*picture.file)), picture.place);
    int const height = kLeafPictureLength;
    int const width = std::clamp(static_cast<int>(std::lround(height * leaf.slenderness())),
                                 kNarrowest, height);
    int const samples = samples_a_side(leaf, image);
    render::Image drawn(width, height);
    std::int64_t on_picture = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            ColorMean mean;
            for (int i = 0; i < samples * samples; ++i) {
                double const across = (i % samples + 0.5) / samples;
                double const down = (i / samples + 0.5) / samples;
                auto const pixel
                    = image.pixel_of(leaf.at(1 - (y + down) / height, (x + across) / width));
                on_picture += image.contains(pixel) ? 1 : 0;
                mean.add(image.color_at(pixel));
            }
            drawn.at(x, y) = mean.mean();
        }
    if (2 * on_picture < std::int64_t { width } * height * samples * samples)
        return fail(Fault::User,
                    "the leaf lies beside the picture: draw it over the picture, or choose a "
                    "colour");
    std::ostringstream png;
    TRY(render::write_png(png, drawn));
    return std::move(png).str();
}

} // namespace tractus::lines
