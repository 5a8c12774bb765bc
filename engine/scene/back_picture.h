#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/edit_kind.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace tractus::scene {

// A background picture to draw over, such as a photograph or an illustration. It lies on the
// tablet: on the upright sheet for tools that draw on paper (paper.h), and flat on the surface for
// all others.

// Position, size and appearance of the picture.
struct PicturePlace {
    // Centre of the picture, in millimetres from the tablet's centre.
    double x_mm = 0;
    double y_mm = 0;
    double width_mm = 200;
    double turn_deg = 0;    // Rotation about its centre, counter-clockwise.
    double strength = 0.5;  // Opacity: 1 is opaque; lower values fade the picture.
    bool is_locked = false; // True if the pen cannot move the picture.

    bool operator==(PicturePlace const&) const = default;
};

// The ground that the picture shows, as specified by the user (picture_ground.h). Positions are on
// the upright sheet, relative to the picture's centre, as shares of the picture's width. They move
// and scale with the picture, but do not rotate with it.
struct PictureGround {
    // Height of the horizon above the picture's centre, as a share of the picture's width.
    std::optional<double> horizon {};
    // An upright object of known height, 0.05 to 200 m: its foot and its top in the picture.
    struct Measured {
        Vec2 foot = Vec2::Zero();
        Vec2 top = Vec2::Zero();
        double height_m = 0;

        bool operator==(Measured const&) const = default;
    };
    std::optional<Measured> measured {};

    bool operator==(PictureGround const&) const = default;
};

struct BackPicture {
    std::string name {}; // Name of the picture's file, for display.
    // Contents of the PNG or JPEG file; never null. Shared between states of the document.
    std::shared_ptr<std::string const> file {};
    PicturePlace place {};
    PictureGround ground {};
};

constexpr double kMinPictureWidth_mm = 1;
constexpr double kGreatestPictureWidth_mm = 10'000;
constexpr double kMinPictureStrength = 0.05;
constexpr std::size_t kMaxPictureBytes = std::size_t { 64 } << 20;

// Sets the background picture of the document; it replaces any earlier one.
struct LayPicture {
    static EditKind const kKind;

    std::string name {};
    std::string file {}; // Contents of the PNG or JPEG file.
    PicturePlace place {};
};

// Changes the position, size or appearance of the background picture.
struct PlacePicture {
    static EditKind const kKind;

    PicturePlace place {};
};

// Sets the ground that the background picture shows.
struct SetPictureGround {
    static EditKind const kKind;

    PictureGround ground {};
};

// Removes the background picture.
struct RemovePicture {
    static EditKind const kKind;
};

} // namespace tractus::scene
