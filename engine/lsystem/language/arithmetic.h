#pragma once

#include "engine/lsystem/language/program.h"

namespace tractus::lsystem {

// Returns true if an operation's result depends on its two operands only.
bool is_pure(Op op);

// Evaluates a pure operation (is_pure()).
double compute(Op op, double left, double right);

} // namespace tractus::lsystem
