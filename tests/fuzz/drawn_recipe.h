#pragma once

#include "tests/fuzz/fuzz_input.h"

#include <optional>
#include <string>

namespace tractus {

// Turns a fuzzer's input into the text of a valid log. The input is a list of operations, each of
// one byte and its arguments: strokes, changes of tool with any options, undo and redo, edits as
// records, pauses, disconnections, reports of any bytes, and tool lines of any words. Devices are
// those of simple_rig() (tests/app/simple_rig.h).
std::string log_of_recipe(FuzzInput input);

} // namespace tractus
