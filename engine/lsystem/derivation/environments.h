#pragma once

#include "engine/lsystem/derivation/query.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/view/environment_choice.h"

namespace tractus::lsystem {

// The built-in environments. Each writes its answer to the first parameter of ?E(answer, ...) and
// to the further parameters below, as far as the module has them. Lengths are in turtle units; y is
// up. All queries of a string are answered together after each step, in the order of the string. An
// environment's state is reset when the axiom is answered. Results are deterministic. Each entry
// ends with the environment's settings and their defaults.
//
// light (Palubicki et al. 2009: shade propagation)
//   ?E(light, weight, x, y, z): an object of this weight (default 1) at the turtle casts shade into
//   the voxels below it, a pyramid of `depth` layers: weight * shade * decay^-layer. `light` is
//   full minus the shade of all other objects, at least 0; (x, y, z) is the direction of more
//   light. cell=1 shade=0.2 decay=2 depth=8 full=1
// space (Mech and Prusinkiewicz 1996: competition for space)
//   ?E(free, radius): 1 if a ball of this radius (default `radius`) touches no ball granted to an
//   earlier ?E, in this step or before; the ball is then granted. Otherwise 0. A query repeated at
//   the same place keeps its ball.
//   radius=1
// terrain
//   ?E(height, x, y, z): the turtle's height above the ground, negative below it, and the ground's
//   normal. The ground rises by `slope` degrees towards +x and has hills.
//   slope=0 hill=0 wave=10
// water (Mech and Prusinkiewicz 1996: roots in soil)
//   ?E(taken, demand, x, y, z): the amount of water that a root of this demand (default 1) gets
//   from its voxel; roots in one voxel share its water. (x, y, z) is the direction of wetter soil.
//   Soil fills y < 0; water diffuses between voxels after each step. cell=1 content=1 uptake=0.1
//   diffusion=0.1
//
// Returns an empty function if no environment is chosen. An environment fails with a user error if
// the plant spans too many voxels or if the time limit is exceeded. The limit is checked after
// every 16,384 visited voxels.
Environment make_environment(EnvironmentChoice const& choice, TimeLimit const& time = {});

} // namespace tractus::lsystem
