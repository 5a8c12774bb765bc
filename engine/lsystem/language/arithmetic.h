#pragma once

#include "engine/lsystem/language/program.h"

namespace tractus::lsystem {

// Returns true if the result of an operation depends only on its two operands.
bool is_pure(Op op);

// Evaluates a pure operation (is_pure()).
double compute(Op op, double left, double right);

} // namespace tractus::lsystem
