#pragma once

#include "app/document/document.h"
#include "engine/base/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace tractus::document {

// A step that no stroke made, in the words of a log's T line (drivers/log.h): "undo", "redo" or
// "begin_again" and a number, or "step", a number, and the step's edits as JSON, each with its
// kind, its fields and in hexadecimal digits its numbers as a session has them (EditRecord). The
// number is that of the strokes before it since the log began: so it is done between the same
// strokes again, however late they are known to have ended.
struct StepWords {
    std::string name;
    std::string arguments;
};

// Returns the words of a step that was done after so many strokes of the log.
StepWords words_for(DoneStep const& step, std::size_t strokes_before);

// No value for a word that no step has. Fails, as the user's fault, for a step in other words than
// above. The edits that are none of `kinds` are UnknownEdits, which are refused when they are to be
// done.
std::optional<Result<LoggedStep>> parse_step(std::string_view name, std::string_view arguments,
                                             scene::EditKinds kinds);

} // namespace tractus::document
