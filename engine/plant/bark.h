#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tractus {

// Kinds of trees whose bark is computed as pictures (engine/export/bark_pictures.h).
enum class BarkKind : std::uint8_t {
    Furrowed, // Furrows along the axis that suit any woody plant; used where no kind is known.
    Alder,
    Apple,
    Ash,
    Beech,
    Birch,
    Cherry,
    Fir,
    Larch,
    Lime,
    Maple,
    Oak,
    Pine,
    Plane,
    Poplar,
    Spruce,
    Willow,
};

// Names of the kinds in habit files, sessions and exported files, in the order of BarkKind. They
// must never change.
constexpr std::array<std::string_view, 17> kBarkNames {
    "furrowed", "alder", "apple", "ash",  "beech", "birch",  "cherry", "fir",   "larch",
    "lime",     "maple", "oak",   "pine", "plane", "poplar", "spruce", "willow"
};

// Bark changes as a limb becomes thicker.
enum class BarkAge : std::uint8_t {
    Young, // Of limbs, still smooth in most species.
    Half,  // The bark of an old trunk appears in places.
    Old,   // Of the foot of an old trunk.
};

// Which bark a material has.
struct Bark {
    BarkKind kind = BarkKind::Furrowed;
    BarkAge age = BarkAge::Old;

    auto operator<=>(Bark const&) const = default;
};

constexpr std::string_view bark_name(BarkKind kind)
{
    return kBarkNames.at(static_cast<std::size_t>(kind));
}

// Returns the mean colour of a bark's pictures, sRGB; for BarkKind::Furrowed, which takes the
// colour of its material, grey-brown.
Vec3f bark_color(Bark const& bark);

// Returns the diameter of limbs, in millimetres, from which their bark is that of old trunks. Those
// thinner than kHalfOldBark times this have young bark.
double old_bark_mm(BarkKind kind);
constexpr double kHalfOldBark = 0.6;

// Returns the age of the bark of a limb.
BarkAge bark_age(BarkKind kind, double diameter_mm);

// Returns the kind with a name. No value if there is none.
constexpr std::optional<BarkKind> bark_kind(std::string_view name)
{
    for (std::size_t i = 0; i < kBarkNames.size(); ++i)
        if (kBarkNames.at(i) == name)
            return static_cast<BarkKind>(i);
    return {};
}

} // namespace tractus
