#pragma once

#include "app/document/document.h"
#include "engine/base/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace tractus::document {

// A step that was not made by a stroke, as a tool line ("T") of a log stores it
// (drivers/logs/log.h): "undo", "redo" or "begin_again" and a number; or "step", a number, and the
// step's edits as JSON. Each edit has its kind, its fields and, in hexadecimal digits, its bulk
// numbers (EditRecord). The number counts the strokes of the log before the step. A replay inserts
// the step between the same strokes, however late it detects the end of a stroke.
struct StepWords {
    std::string name;
    std::string arguments;
};

// Returns the words for a step that was done after `strokes_before` strokes of the log.
StepWords words_for(StepOutcome const& step, std::size_t strokes_before);

// Parses a step's words. Returns nullopt if the name does not belong to a step. Fails with a user
// error if the arguments do not have the form of StepWords. Edits whose kind is not among `kinds`
// become UnknownEdits, which are refused when the step is done.
std::optional<Result<LoggedStep>> parse_step(std::string_view name, std::string_view arguments,
                                             scene::EditKinds kinds);

} // namespace tractus::document
