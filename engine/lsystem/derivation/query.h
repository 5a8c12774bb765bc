#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/lsystem/language/virtual_machine.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tractus::lsystem {

// A module ?E(…) in a string, as an environment sees it. In the turtle's space, as models have it:
// x right, y up, z to the viewer; lengths in turtle units.
struct EnvironmentQuery {
    std::size_t module = 0; // Place of the ?E in the string.
    Vec3 position = Vec3::Zero();
    Vec3 heading = Vec3::UnitY();
    Vec3 left = -Vec3::UnitX();
    Vec3 up = -Vec3::UnitZ();
    double line_width = 0;
    double scale = 1;
    // The symbol behind the ?E, such as the organ that is asked about; 0 at the string's end.
    char next_symbol = 0;
    std::span<float const> next_parameters;
    std::span<float> parameters; // Parameters of the ?E: to be read, and set as the answer.
};

// Answers all ?E of a string at once, in the order of the string: an environment in which plants
// compete must see them together. `step` is 0 for the axiom. An error ends the derivation.
using Environment
    = std::function<Result<void>(int step, std::span<EnvironmentQuery const> queries)>;

// Whether strings of the model can have query modules, ?P ?H ?L ?U ?Q or ?E.
bool has_queries(Model const& model);

// Whether strings of the model can keep what %(x) cuts off: it goes to the string's end, where the
// turtle begins as it was at the cut.
bool keeps_cuts(Model const& model);

// Runs the turtle over the string, without drawing, notes where it comes to a %(x), and fills its
// query modules: ?P(x,y,z) with the turtle's position, ?H ?L ?U(x,y,z) with the directions of its
// frame, ?Q(x,y,z,w) with the quaternion that turns x, y and z into ?H, ?L and away from ?U; then
// asks the environment, if there is one, about the ?E. A query with fewer parameters gets the first
// of the values; one that a homomorphism rule makes gets none. As in cpfg, what a cut will take
// away in the next step is answered as well, unless the view lets the turtle stop at cuts: then it
// keeps its values. What the turtle does to the string's variables, by homomorphism rules, is
// forgotten. Fails like apply_homomorphism().
Result<void> answer_queries(Model const& model, ModuleString& string, VirtualMachine const& main,
                            int step, Environment const& environment);

} // namespace tractus::lsystem
