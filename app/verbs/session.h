#pragma once

#include "app/verbs/verb.h"

namespace tractus {

void add_session_verb(CLI::App& root, Action& action);

} // namespace tractus
