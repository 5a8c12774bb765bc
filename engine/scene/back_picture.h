#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/edit_kind.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace tractus::scene {

// A picture that lies behind what is drawn, to be drawn after: a photograph, an illustration. It
// lies on the tablet: on the sheet for tools that draw on paper (paper.h), and flat on the surface
// for all others.

// Where and how it lies.
struct PicturePlace {
    // Its middle, in tablet-centred millimetres.
    double x_mm = 0;
    double y_mm = 0;
    double width_mm = 200;
    double turn_deg = 0;    // Counter-clockwise about its middle.
    double strength = 0.5;  // 1: as it is; towards 0 it fades into the background.
    bool is_locked = false; // The pen leaves it as it lies.

    bool operator==(PicturePlace const&) const = default;
};

// What a person says of the ground that the picture shows (picture_ground.h). Places are on the
// sheet, from the picture's middle, as shares of its width: they go with the picture where it is
// moved and sized, and stay where they are when it turns.
struct PictureGround {
    std::optional<double> horizon {}; // How far above the middle it is.
    // Something upright of a known height, 0.05 to 200 m, by its foot and its top.
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
    std::string name {}; // For people: of the file that it came from.
    // The whole file, a PNG or a JPEG; never null. Shared with earlier states.
    std::shared_ptr<std::string const> file {};
    PicturePlace place {};
    PictureGround ground {};
};

constexpr double kLeastPictureWidth_mm = 1;
constexpr double kGreatestPictureWidth_mm = 10'000;
constexpr double kLeastPictureStrength = 0.05;
constexpr std::size_t kMostPictureBytes = std::size_t { 64 } << 20;

// Lays a picture behind what is drawn, in place of the one that lies there.
struct LayPicture {
    static EditKind const kKind;

    std::string name {};
    std::string file {}; // All of it.
    PicturePlace place {};
};

// Lets the picture lie somewhere else, or otherwise.
struct PlacePicture {
    static EditKind const kKind;

    PicturePlace place {};
};

// Says what ground the picture shows.
struct SetPictureGround {
    static EditKind const kKind;

    PictureGround ground {};
};

// Takes the picture away.
struct RemovePicture {
    static EditKind const kKind;
};

} // namespace tractus::scene
