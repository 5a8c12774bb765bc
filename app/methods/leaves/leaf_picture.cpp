#include "app/methods/leaves/leaf_picture.h"

#include "app/methods/leaves/leaf_library.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/core.h>

namespace tractus::leaf {

render::Image on_paper(leaf::LeafPicture const& picture, render::Color const& paper)
{
    render::Image image(picture.side, picture.side, paper);
    auto const over = [](std::uint8_t top, std::uint8_t below, double alpha) {
        return static_cast<std::uint8_t>(std::lround(alpha * top + (1 - alpha) * below));
    };
    for (std::size_t i = 0; i < picture.color.size(); ++i) {
        auto const& [red, green, blue, alpha] = picture.color[i];
        // Shades the pixel by its normal, with light from the upper left.
        auto const& normal = picture.normal[i];
        double const light = std::clamp(
            1 + 0.45 * (normal[1] - 128) / 127.0 - 0.35 * (normal[0] - 128) / 127.0, 0.7, 1.3);
        auto const lit = [&](std::uint8_t value) {
            return static_cast<std::uint8_t>(std::clamp(std::lround(light * value), 0l, 255l));
        };
        double const share = alpha / 255.0;
        image.pixels()[i]
            = { over(lit(red), paper.red, share), over(lit(green), paper.green, share),
                over(lit(blue), paper.blue, share), 255 };
    }
    return image;
}

Result<render::Image> picture_of_leaf(leaf::Grammar const& grammar, int side,
                                      render::Color const& paper)
{
    LeafLife const life {};
    auto const grown = TRY(grow_leaf(grammar, life));
    if (!(leaf::PictureFrame(grown.triangles, side).scale > 0) || grown.triangles.veins.empty())
        return fail(Fault::User, fmt::format("{}: the leaf has no extent", grammar.name));
    auto options = paint_options(grammar, life);
    options.side = side;
    return on_paper(leaf::paint_leaf(grown.leaf, grown.triangles, options), paper);
}

} // namespace tractus::leaf
