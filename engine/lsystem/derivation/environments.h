#pragma once

#include "engine/lsystem/derivation/query.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/view/environment_choice.h"

namespace tractus::lsystem {

// The built-in environments. Each answers in the first parameter of ?E(answer, …); the others that
// are read or set stand behind it, as far as a module has them. Lengths are in turtle units, y is
// up. All of a string are answered together, after each step, in the order of the string; what an
// environment remembers begins anew with the axiom. Deterministic.
//
// light (Palubicki et al. 2009: shade propagation)
//   ?E(light, weight, x, y, z): what stands at the turtle, of this weight (1 without the
//   parameter), casts shade into the voxels below it, a pyramid of `depth` layers:
//   weight * shade * decay^-layer. light is full minus the shade of all others, at least 0;
//   (x, y, z) is the direction in which there is more of it.
//   cell=1 shade=0.2 decay=2 depth=8 full=1
// space (Mech and Prusinkiewicz 1996: competition for space)
//   ?E(free, radius): 1 if a ball of this radius (`radius` without the parameter) touches none that
//   an earlier ?E got, in this step or before, and then it is taken; otherwise 0. Who asks again at
//   the same place keeps it.
//   radius=1
// terrain
//   ?E(height, x, y, z): the turtle's height above the ground, less than 0 below it, and the
//   ground's normal. The ground rises by `slope` degrees to +x and has hills.
//   slope=0 hill=0 wave=10
// water (Mech and Prusinkiewicz 1996: roots in soil)
//   ?E(taken, demand, x, y, z): what a root of this demand (1 without the parameter) gets of its
//   voxel's water; those in one voxel share. (x, y, z) is the direction to wetter soil. Soil lies
//   below y = 0; water spreads between voxels after each step.
//   cell=1 content=1 uptake=0.1 diffusion=0.1
//
// The function is empty if no environment is chosen. It fails, as the user's fault, when the plant
// spans too many voxels and when the time is over, which is asked about every few thousand voxels.
Environment make_environment(EnvironmentChoice const& choice, TimeLimit const& time = {});

} // namespace tractus::lsystem
