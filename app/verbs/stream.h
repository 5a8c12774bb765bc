#pragma once

#include "app/tools/methods.h"
#include "app/verbs/verb.h"

namespace tractus {

// `tractus stream [LOG]`: tips and strokes as lines for other programs.
void add_stream_verb(CLI::App& root, Action& action, Methods const& methods);

} // namespace tractus
