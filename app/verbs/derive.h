#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus derive MODEL.l: rewrites a model's string and prints it, or what it consists of.
void add_derive_verb(CLI::App& root, Action& action);

} // namespace tractus
