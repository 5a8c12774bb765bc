#include "app/methods/pictures/picture_tool.h"

#include "app/tools/erase_tool.h"
#include "app/tools/tool.h"
#include "engine/scene/back_picture.h"
#include "engine/scene/picture_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tractus::pictures {

namespace {

using Does = PictureTool::Does;

// Option words, in the order of the enumeration Does.
constexpr std::array<tools::OptionWord, 6> kDoesWords { {
    { "move", "Move", "Move the picture" },
    { "size", "Size", "Size the picture" },
    { "turn", "Turn", "Turn the picture" },
    { "ground", "Ground", "Draw the horizon, or along something of known height" },
    { "lock", "Lock", nullptr, true },
    { "remove", "Remove", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, PictureTool& tool)
{
    visitor.choice({ kDoesWords }, tool.does);
    visitor.number({ .name = "strength",
                     .unit = "%",
                     .least = 100 * scene::kMinPictureStrength,
                     .greatest = 100,
                     .step = 5,
                     .label = "Strength" },
                   tool.strength_percent);
    visitor.number({ .name = "height",
                     .unit = "m",
                     .least = 0.1,
                     .greatest = 200,
                     .step = 0.1,
                     .label = "Known height" },
                   tool.height_m);
}

Result<scene::PicturePlace> place_of(scene::Scene const& scene)
{
    if (!scene.state.picture)
        return fail(Fault::User, "no picture lies behind what is drawn: open one first");
    return scene.state.picture->place;
}

// Returns the picture's place after a stroke has moved the picture, or has scaled or rotated it
// about its centre.
Result<scene::PicturePlace> dragged(scene::PicturePlace place, Does does, Vec2 const& from_mm,
                                    Vec2 const& to_mm)
{
    constexpr double kMinLever_mm = 3;
    Vec2 const middle_mm(place.x_mm, place.y_mm);
    Vec2 const from = from_mm - middle_mm;
    Vec2 const to = to_mm - middle_mm;
    if (does == Does::Move) {
        place.x_mm += to_mm.x() - from_mm.x();
        place.y_mm += to_mm.y() - from_mm.y();
        return place;
    }
    if (std::min(from.norm(), to.norm()) < kMinLever_mm)
        return fail(Fault::User,
                    "the stroke begins or ends at the picture's middle, about which it is sized "
                    "and turned: draw it farther out");
    if (does == Does::Size) {
        place.width_mm = std::clamp(place.width_mm * to.norm() / from.norm(),
                                    scene::kMinPictureWidth_mm, scene::kGreatestPictureWidth_mm);
        return place;
    }
    double const by_rad = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    place.turn_deg = std::remainder(place.turn_deg + by_rad * 180 / std::numbers::pi, 360);
    return place;
}

// Interprets a stroke that places the ground in the picture: a horizontal stroke is the horizon; a
// vertical stroke marks an object of height `height_m`.
Result<scene::PictureGround> ground_drawn(scene::BackPicture const& picture, Stroke const& stroke,
                                          double height_m)
{
    constexpr double kShortest_mm = 3;
    Vec2 const from_mm = stroke.tips.front().position_mm.head<2>();
    Vec2 const to_mm = stroke.tips.back().position_mm.head<2>();
    Vec2 const way = to_mm - from_mm;
    if (way.norm() < kShortest_mm)
        return fail(Fault::User,
                    "that is a dot: draw the horizon from side to side, or from the foot of "
                    "something of known height to its top");
    auto ground = picture.ground;
    auto const from = scene::on_picture(picture.place, from_mm);
    auto const to = scene::on_picture(picture.place, to_mm);
    if (std::abs(way.x()) > std::abs(way.y()))
        ground.horizon = (from.y() + to.y()) / 2;
    else
        ground.measured = { .foot = way.y() > 0 ? from : to,
                            .top = way.y() > 0 ? to : from,
                            .height_m = height_m };
    TRY(scene::check_ground(ground));
    return ground;
}

Result<std::vector<scene::Edit>> edits_for(tools::Tool const& tool, Stroke const& stroke,
                                           scene::Scene const& scene)
{
    auto const does = tool.get<PictureTool>()->does;
    auto place = TRY(place_of(scene));
    if (does == Does::Remove)
        return std::vector<scene::Edit> { scene::RemovePicture {} };
    if (does == Does::Lock) {
        place.is_locked = !place.is_locked;
        return std::vector<scene::Edit> { scene::PlacePicture { place } };
    }
    if (does == Does::Ground)
        return std::vector<scene::Edit> { scene::SetPictureGround {
            TRY(ground_drawn(*scene.state.picture, stroke, tool.get<PictureTool>()->height_m)) } };
    if (place.is_locked)
        return fail(Fault::User, "the picture is locked: press Lock to let it go");
    return std::vector<scene::Edit> { scene::PlacePicture {
        TRY(dragged(place, does, stroke.tips.front().position_mm.head<2>(),
                    stroke.tips.back().position_mm.head<2>())) } };
}

std::string describe_ground(scene::PictureGround const& ground)
{
    if (!ground.measured)
        return "The horizon is there: now draw along something of known height, from its foot up";
    if (!ground.horizon)
        return "The height is known: draw the horizon, too, and trees stand nearer and farther "
               "away";
    return "A tree's foot says where it stands now, and its outline how tall it is";
}

std::string describe_change(tools::Tool const& tool, scene::Scene const& after)
{
    auto const does = tool.get<PictureTool>()->does;
    if (does == Does::Remove)
        return "The picture is gone";
    if (does == Does::Ground && after.state.picture)
        return describe_ground(after.state.picture->ground);
    if (does != Does::Lock)
        return {};
    return after.state.picture && after.state.picture->place.is_locked
        ? "The picture stays where it lies: press Lock once more to let it go"
        : "The picture can be moved";
}

// Sets the picture's opacity to that of the tool, even if the picture is locked.
std::vector<scene::Edit> follow(tools::Tool const&, tools::Tool const& after,
                                scene::Scene const& scene)
{
    if (!scene.state.picture)
        return {};
    auto place = scene.state.picture->place;
    double const strength = after.get<PictureTool>()->strength_percent / 100;
    if (std::exchange(place.strength, strength) == strength)
        return {};
    return { scene::PlacePicture { place } };
}

} // namespace

constexpr tools::ToolKind PictureTool::kKind {
    .word = "back_picture",
    .label = "Picture",
    .title = "Place the picture",
    .done = "The picture lies there now",
    .help
    = "moves the picture behind what is drawn along with the stroke, sizes it or turns it "
      "about its middle; locks it, takes it away; a level stroke says where its horizon is, an "
      "upright one where something stands that is so tall, and trees stand on that ground",
    .group = "Picture",
    .icon = "1282871712 174467 567486",
    .surface = tools::Surface::Paper,
    .min_extent_mm = 2,
    .ink = { tools::InkStyle::Look::Arrow },
    .shows_outcome = true,
    .lays_pictures = true,
    .options = tools::options_type<PictureTool, visit>(),
    .edits_for = edits_for,
    .follow = follow,
    .describe = describe_change,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::pictures
