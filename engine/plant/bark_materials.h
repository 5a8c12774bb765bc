#pragma once

#include "engine/plant/bark.h"
#include "engine/plant/plant.h"

#include <array>

namespace tractus {

// The materials of a tree whose bark changes with the girth.
struct BarkMaterials {
    BarkKind kind = BarkKind::Furrowed;
    std::array<MaterialId, 3> of_age {}; // By BarkAge.

    // The material of a limb.
    MaterialId at(double diameter_mm) const
    {
        return of_age.at(static_cast<std::size_t>(bark_age(kind, diameter_mm)));
    }
};

// Gives a plant the bark of a kind. The material `bark` becomes that of an old trunk and keeps its
// colour; those of young and half-old limbs, tinted like it, are added after all other materials.
// With BarkKind::Furrowed nothing changes, and all limbs have the material `bark`.
BarkMaterials add_bark(Plant& plant, MaterialId bark, BarkKind kind);

} // namespace tractus
