#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus decode FILE [--csv [--raw] [-o FILE]]: what a device log's pens did.
void add_decode_verb(CLI::App& root, Action& action);

} // namespace tractus
