#include "app/methods/silhouettes/touched_crown.h"

#include "app/render/image.h"
#include "app/render/read_picture.h"
#include "engine/methods/silhouettes/picture_crown.h"
#include "engine/methods/silhouettes/plane.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tractus::silhouette {

namespace {

using silhouette::PictureGrid;

// The image, reduced to a size at which crowns can be found quickly.
PictureGrid grid_of(render::Image const& image)
{
    int const width = std::min(image.width(), silhouette::kPictureGridWidth);
    int const height = std::max(1, width * image.height() / std::max(1, image.width()));
    auto const small = render::resized(image, width, height);
    PictureGrid grid { width, height, {} };
    for (auto const& color : small.pixels())
        grid.pixels.push_back(Vec3f(color.red, color.green, color.blue) / 255);
    return grid;
}

// Maps the pixels of the grid, x to the right and y up from the lower left corner, to the sheet.
silhouette::Similarity to_sheet(scene::PicturePlace const& place, PictureGrid const& grid)
{
    double const unit = place.width_mm / grid.width;
    return { .from = Vec2(grid.width, grid.height) / 2,
             .to = Vec2(place.x_mm, place.y_mm),
             .turn = silhouette::turned(Vec2(unit, 0), radians(place.turn_deg)) };
}

silhouette::Similarity to_pixels(silhouette::Similarity const& way)
{
    Vec2 const back = Vec2(way.turn.x(), -way.turn.y()) / way.turn.squaredNorm();
    return { .from = way.to, .to = way.from, .turn = back };
}

} // namespace

Result<Stroke> outline_touched(scene::BackPicture const& picture, Stroke const& touch)
{
    constexpr auto kStep = Duration(5'000'000);
    auto const image = TRY(render::read_picture(*picture.file));
    auto const grid = grid_of(image);
    auto const way = to_sheet(picture.place, grid);
    auto tip = TRY(touch.tips.in_memory()).front();
    Vec2 const place_mm = tip.position_mm.head<2>();
    auto outline = TRY(silhouette::find_crown_in_picture(grid, to_pixels(way).point(place_mm)));
    outline.push_back(outline.front());
    std::vector<TipSample> tips;
    for (auto const& point : outline) {
        tip.position_mm.head<2>() = way.point(point);
        tips.push_back(tip);
        tip.time += kStep;
    }
    return Stroke { std::move(tips) };
}

} // namespace tractus::silhouette
