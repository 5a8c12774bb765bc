#pragma once

#include "app/tools/methods.h"
#include "app/verbs/verb.h"

namespace tractus {

void add_session_verb(CLI::App& root, Action& action, Methods const& methods);

} // namespace tractus
