#include "engine/scene/picture_ground.h"

#include <cmath>
#include <fmt/core.h>

namespace tractus::scene {

namespace {

// Minimum distance of an object's foot below the horizon, as a share of the picture's width.
constexpr double kMinDrop = 0.004;

} // namespace

Result<void> check_ground(PictureGround const& ground)
{
    constexpr double kLowest_m = 0.05;
    constexpr double kHighest_m = 200;
    if (ground.horizon && !std::isfinite(*ground.horizon))
        return fail(Fault::User, "the horizon is nowhere: draw it across the picture");
    if (!ground.measured)
        return {};
    auto const& [foot, top, height_m] = *ground.measured;
    if (!foot.allFinite() || !top.allFinite() || !(top.y() > foot.y()))
        return fail(Fault::User,
                    "the known height has no top above its foot: draw along it, upwards");
    if (!(height_m >= kLowest_m && height_m <= kHighest_m))
        return fail(Fault::User,
                    fmt::format("a height of {:g} m is out of range: {:g} to {:g} m "
                                "are possible",
                                height_m, kLowest_m, kHighest_m));
    if (ground.horizon && foot.y() > *ground.horizon - kMinDrop)
        return fail(Fault::User,
                    "the foot of the known height is not below the horizon: the ground is seen "
                    "only below that");
    return {};
}

Vec2 on_picture(PicturePlace const& place, Vec2 const& sheet_mm)
{
    return (sheet_mm - Vec2(place.x_mm, place.y_mm)) / place.width_mm;
}

Result<std::optional<GroundPlace>> place_on_ground(BackPicture const& picture, Vec2 const& foot_mm)
{
    // Focal length as a share of the picture's width, for an angle of view of 53 degrees.
    constexpr double kFocalLength = 1;
    auto const& measured = picture.ground.measured;
    if (!measured)
        return std::nullopt;
    double const width_mm = picture.place.width_mm;
    Vec2 const foot = on_picture(picture.place, foot_mm);
    double const m_per_share = measured->height_m / (measured->top.y() - measured->foot.y());
    if (!picture.ground.horizon)
        return GroundPlace { .right_m = foot.x() * m_per_share,
                             .m_per_mm = m_per_share / width_mm };
    double const horizon = *picture.ground.horizon;
    double const drop = horizon - foot.y();
    if (drop < kMinDrop)
        return fail(Fault::User,
                    "the trunk's foot is not below the picture's horizon: draw the trunk from "
                    "where it leaves the ground");
    double const known_drop = horizon - measured->foot.y();
    double const camera_m = m_per_share * known_drop;
    return GroundPlace { .right_m = foot.x() * camera_m / drop,
                         .behind_m = kFocalLength * camera_m * (1 / drop - 1 / known_drop),
                         .m_per_mm = camera_m / drop / width_mm };
}

} // namespace tractus::scene
