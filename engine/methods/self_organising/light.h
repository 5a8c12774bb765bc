#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/light_grid.h"
#include "engine/methods/self_organising/markers.h"

#include <span>
#include <vector>

namespace tractus::self_organising {

// The light that a tree's buds receive, and the shade that the buds and other points cast.
struct Light {
    LightGrid grid;
    // Light Q received by each bud: 0 in full shade, Laws::full_light without any shade.
    std::vector<double> quality;
};

// Computes the light that each bud receives. `others` are further points that cast shade, such as
// buds of neighbouring trees. Fails like LightGrid::make().
Result<Light> compete_for_light(GrowingTree const& tree, std::vector<Bud> const& buds,
                                std::span<Vec3 const> others, Laws const& laws);

// The unit vector from a bud to the least shaded cell within its perception cone; zero if the cone
// contains no cell. Ties go to the first cell in scanning order: top layer first, then along y,
// then along x.
Vec3 brightest_direction(LightGrid const& grid, Vec3 const& position, Vec3 const& direction,
                         Laws const& laws);

} // namespace tractus::self_organising
