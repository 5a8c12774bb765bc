#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// `tractus doctor`: what keeps the devices from working, and what to do about it.
void add_doctor_verb(CLI::App& root, Action& action);

} // namespace tractus
