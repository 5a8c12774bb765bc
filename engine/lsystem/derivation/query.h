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

// A query module ?E(...) with the turtle's state, as an environment sees it. Vectors are in cpfg's
// space: x right, y up, z towards the viewer. Lengths are in turtle units.
struct EnvironmentQuery {
    std::size_t module = 0; // Index of the ?E in the string.
    Vec3 position = Vec3::Zero();
    Vec3 heading = Vec3::UnitY();
    Vec3 left = -Vec3::UnitX();
    Vec3 up = -Vec3::UnitZ();
    double line_width = 0;
    double scale = 1;
    // Symbol after the ?E, such as an organ that the query is about; 0 if the ?E is the last
    // module.
    char next_symbol = 0;
    std::span<float const> next_parameters;
    std::span<float> parameters; // Parameters of the ?E: its input, which the answer overwrites.
};

// Answers all ?E modules of a string in one call, in the order of the string, because competing
// plants must see each other. `step` is 0 for the axiom. An error ends the derivation.
using Environment
    = std::function<Result<void>(int step, std::span<EnvironmentQuery const> queries)>;

// Returns true if strings of the model may contain query modules: ?P, ?H, ?L, ?U, ?Q or ?E.
bool has_queries(Model const& model);

// Returns true if the model's strings may keep branches that a %(x) cuts off. Such a branch moves
// to the end of the string, where its turtle starts in the state that it had at the cut.
bool keeps_cuts(Model const& model);

// Runs the turtle over the string without drawing, records its state at each %(x), and fills the
// query modules: ?P(x,y,z) with the turtle's position; ?H, ?L and ?U(x,y,z) with the vectors of its
// frame; ?Q(x,y,z,w) with the quaternion that rotates the x, y and z axes to ?H, ?L and the
// opposite of ?U. Then calls the environment, if any, for the ?E modules. A query with fewer
// parameters gets the first values. A query made by a homomorphism rule gets none.
//
// As in cpfg, queries in a part that a cut will remove in the next step are answered, too. If the
// view stops the turtle at cuts they are not, and keep their values. Changes of variables by
// homomorphism rules are discarded. Fails like apply_homomorphism().
Result<void> answer_queries(Model const& model, ModuleString& string, VirtualMachine const& main,
                            int step, Environment const& environment);

} // namespace tractus::lsystem
