#include "engine/scene/back_picture.h"

#include "engine/scene/make_edit_kind.h"
#include "engine/scene/picture_ground.h"

#include <cmath>
#include <fmt/core.h>
#include <string_view>
#include <utility>

namespace tractus::scene {

namespace {

void list(Fields& fields, PicturePlace& place)
{
    fields.field("x_mm", &place.x_mm);
    fields.field("y_mm", &place.y_mm);
    fields.field("width_mm", &place.width_mm);
    fields.field("turn_deg", &place.turn_deg);
    fields.field("strength", &place.strength);
    fields.field("locked", &place.is_locked);
}

void list(Fields& fields, LayPicture& edit)
{
    fields.field("name", &edit.name);
    list(fields, edit.place);
    fields.bytes(edit.file);
}

void list(Fields& fields, PlacePicture& edit)
{
    list(fields, edit.place);
}

void list(Fields& fields, SetPictureGround& edit)
{
    auto& ground = edit.ground;
    bool has_horizon = ground.horizon.has_value();
    double horizon = ground.horizon.value_or(0);
    fields.sparse_field("has_horizon", &has_horizon);
    fields.sparse_field("horizon", &horizon);
    ground.horizon = has_horizon ? std::optional(horizon) : std::nullopt;
    bool is_measured = ground.measured.has_value();
    auto measured = ground.measured.value_or(PictureGround::Measured {});
    fields.sparse_field("measured", &is_measured);
    fields.sparse_field("foot_x", &measured.foot.x());
    fields.sparse_field("foot_y", &measured.foot.y());
    fields.sparse_field("top_x", &measured.top.x());
    fields.sparse_field("top_y", &measured.top.y());
    fields.sparse_field("height_m", &measured.height_m);
    ground.measured = is_measured ? std::optional(measured) : std::nullopt;
}

void list(Fields&, RemovePicture&) { }

Result<void> check_place(PicturePlace const& place)
{
    constexpr double kFarthest_mm = 10'000;
    bool const is_near
        = std::abs(place.x_mm) <= kFarthest_mm && std::abs(place.y_mm) <= kFarthest_mm;
    if (!is_near || !std::isfinite(place.turn_deg))
        return fail(Fault::User, "the picture would lie more than ten metres away");
    if (!(place.width_mm >= kMinPictureWidth_mm && place.width_mm <= kGreatestPictureWidth_mm))
        return fail(Fault::User,
                    fmt::format("a picture {:g} mm wide is out of range: {:g} to {:g} mm are "
                                "possible",
                                place.width_mm, kMinPictureWidth_mm, kGreatestPictureWidth_mm));
    if (!(place.strength >= kMinPictureStrength && place.strength <= 1))
        return fail(Fault::User,
                    fmt::format("a picture's strength of {:g} is out of range: {:g} to 1 are "
                                "possible",
                                place.strength, kMinPictureStrength));
    return {};
}

bool is_picture(std::string_view file)
{
    return file.starts_with("\x89PNG\r\n\x1a\n") || file.starts_with("\xff\xd8\xff");
}

Result<DocumentState> applied(DocumentState state, LayPicture const& edit, SceneBuilder&)
{
    TRY(check_place(edit.place));
    if (edit.file.size() > kMaxPictureBytes)
        return fail(Fault::User,
                    fmt::format("{} has {} MB, more than the {} MB that a drawing keeps: make it "
                                "smaller",
                                edit.name, edit.file.size() >> 20, kMaxPictureBytes >> 20));
    if (!is_picture(edit.file))
        return fail(Fault::User, fmt::format("{} is neither a PNG nor a JPEG picture", edit.name));
    state.picture = std::make_shared<BackPicture const>(
        BackPicture { edit.name, std::make_shared<std::string const>(edit.file), edit.place });
    return state;
}

Result<DocumentState> applied(DocumentState state, PlacePicture const& edit, SceneBuilder&)
{
    TRY(check_place(edit.place));
    if (!state.picture)
        return fail(Fault::User, "no picture lies behind what is drawn");
    auto picture = *state.picture;
    picture.place = edit.place;
    state.picture = std::make_shared<BackPicture const>(std::move(picture));
    return state;
}

Result<DocumentState> applied(DocumentState state, SetPictureGround const& edit, SceneBuilder&)
{
    TRY(check_ground(edit.ground));
    if (!state.picture)
        return fail(Fault::User, "no picture lies behind what is drawn");
    auto picture = *state.picture;
    picture.ground = edit.ground;
    state.picture = std::make_shared<BackPicture const>(std::move(picture));
    return state;
}

Result<DocumentState> applied(DocumentState state, RemovePicture const&, SceneBuilder&)
{
    if (!state.picture)
        return fail(Fault::User, "no picture lies behind what is drawn");
    state.picture.reset();
    return state;
}

std::string described(PicturePlace const& place)
{
    return fmt::format(
        "{:.4g} mm wide, its middle at {:.4g}, {:.4g} mm{}{}", place.width_mm, place.x_mm,
        place.y_mm, place.turn_deg == 0 ? "" : fmt::format(", turned by {:.3g}°", place.turn_deg),
        place.is_locked ? ", locked" : "");
}

std::string described(LayPicture const& edit)
{
    return fmt::format("lays the picture {} behind what is drawn, {}", edit.name,
                       described(edit.place));
}

std::string described(PlacePicture const& edit)
{
    return fmt::format("lets the picture lie {}", described(edit.place));
}

std::string described(SetPictureGround const& edit)
{
    auto const& ground = edit.ground;
    return fmt::format(
        "says of the picture that its horizon is {}, and that {}",
        ground.horizon ? fmt::format("{:.3g} of its width above its middle", *ground.horizon)
                       : std::string("not known"),
        ground.measured ? fmt::format("something in it is {:.3g} m tall", ground.measured->height_m)
                        : std::string("no height in it is known"));
}

std::string described(RemovePicture const&)
{
    return "takes the picture away";
}

} // namespace

constexpr EditKind LayPicture::kKind
    = make_edit_kind<LayPicture, list, applied, described>("lay_picture");

constexpr EditKind PlacePicture::kKind
    = make_edit_kind<PlacePicture, list, applied, described>("place_picture");

constexpr EditKind SetPictureGround::kKind
    = make_edit_kind<SetPictureGround, list, applied, described>("set_picture_ground");

constexpr EditKind RemovePicture::kKind
    = make_edit_kind<RemovePicture, list, applied, described>("remove_picture");

} // namespace tractus::scene
