#include "app/methods/leaves/leaf_study.h"

#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_picture.h"
#include "engine/base/parallel.h"
#include "engine/lsystem/view/leaf_sheet.h"

#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr int kSide = 384;      // Side of the pictures of the leaf and its maps, in pixels.
constexpr int kOtherSide = 160; // Side of the pictures of further leaves, in pixels.
constexpr int kOthers = 6;

std::uint8_t over(std::uint8_t top, std::uint8_t below, double alpha)
{
    return static_cast<std::uint8_t>(std::lround(alpha * top + (1 - alpha) * below));
}

// Draws a map inside the leaf, and paper around it. `color_of` returns the map's colour at a pixel.
template<typename ColorOf>
render::Image map_on_paper(leaf::LeafPicture const& picture, render::Color const& paper,
                           ColorOf const& color_of)
{
    render::Image image(picture.side, picture.side, paper);
    for (std::size_t i = 0; i < picture.color.size(); ++i) {
        double const share = picture.color[i][3] / 255.0;
        render::Color const color = color_of(i);
        image.pixels()[i]
            = { over(color.red, paper.red, share), over(color.green, paper.green, share),
                over(color.blue, paper.blue, share), 255 };
    }
    return image;
}

Result<leaf::LeafPicture> painted(leaf::Grammar const& grammar, LeafLife const& life,
                                  lsystem::LeafDamage const& damage, int side, bool has_underside)
{
    auto const grown = TRY(grow_leaf(grammar, life));
    if (!(leaf::PictureFrame(grown.triangles, side).scale > 0) || grown.triangles.veins.empty())
        return fail(Fault::User, fmt::format("{}: the leaf has no extent", grammar.name));
    auto options = paint_options(grammar, life);
    options.side = side;
    options.has_underside = has_underside;
    paint_damage(options, damage);
    return leaf::paint_leaf(grown.leaf, grown.triangles, options);
}

void show_with_maps(leaf::LeafPicture const& picture, render::Color const& paper, LeafStudy& study)
{
    auto const gray = [](std::uint8_t value) { return render::Color { value, value, value, 255 }; };
    auto const rgb = [](auto const& value) {
        return render::Color { value[0], value[1], value[2], 255 };
    };
    study.leaf = on_paper(picture, paper);
    study.relief
        = map_on_paper(picture, paper, [&](std::size_t i) { return rgb(picture.normal[i]); });
    study.roughness = map_on_paper(picture, paper,
                                   [&](std::size_t i) { return gray(picture.roughness[i][1]); });
    study.translucency = map_on_paper(picture, paper,
                                      [&](std::size_t i) { return gray(picture.translucency[i]); });
    study.below
        = map_on_paper(picture, paper, [&](std::size_t i) { return rgb(picture.under_color[i]); });
}

} // namespace

Result<LeafStudy> study_leaf(leaf::Grammar const& grammar, LeafLook const& look,
                             render::Color const& paper)
{
    lsystem::LeafOrder const order { .age = look.age, .spread = look.spread };
    LeafStudy study;
    study.others.resize(kOthers);
    std::vector<std::optional<Error>> errors(1 + kOthers);
    auto const paint = [&](std::size_t task) -> Result<void> {
        if (task == 0) {
            auto const picture
                = TRY(painted(grammar, { .age = look.age }, look.damage, kSide, true));
            show_with_maps(picture, paper, study);
            return {};
        }
        // The further leaves have the same ages as in grow_leaf_sheet().
        int const number = static_cast<int>(task) - 1;
        LeafLife const life { .age = lsystem::leaf_age(order, number), .seed = task };
        auto const picture
            = TRY(painted(grammar, life, damage_of_leaf(look.damage, number), kOtherSide, false));
        study.others[task - 1] = on_paper(picture, paper);
        return {};
    };
    parallel_for(errors.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t task = begin; task < end; ++task)
            if (auto const done = paint(task); !done)
                errors[task] = done.error();
    });
    for (auto const& error : errors)
        if (error)
            return tl::unexpected(*error);
    return study;
}

} // namespace tractus::leaf
