#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/light_grid.h"
#include "engine/methods/self_organising/markers.h"

#include <span>
#include <vector>

namespace tractus::self_organising {

// The light that a tree's buds receive, and the shade that all cast.
struct Light {
    LightGrid grid;
    std::vector<double> quality; // Q, one for each bud: 0 in full shade, full_light without any.
};

// `others`: places of what shades besides, such as neighbours' buds. Fails like LightGrid::make().
Result<Light> compete_for_light(GrowingTree const& tree, std::vector<Bud> const& buds,
                                std::span<Vec3 const> others, Laws const& laws);

// The unit vector from a bud to the least shaded cell that it perceives, the first of equals from
// the top layer down, along y, then along x. Zero where it perceives none.
Vec3 brightest_direction(LightGrid const& grid, Vec3 const& position, Vec3 const& direction,
                         Laws const& laws);

} // namespace tractus::self_organising
