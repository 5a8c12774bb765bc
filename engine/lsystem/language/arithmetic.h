#pragma once

#include "engine/lsystem/language/program.h"

namespace tractus::lsystem {

// Whether an instruction depends on nothing but its two operands.
bool is_pure(Op op);

// The value of a pure operation.
double compute(Op op, double left, double right);

} // namespace tractus::lsystem
