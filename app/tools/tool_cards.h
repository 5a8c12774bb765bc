#pragma once

#include "app/tools/tool.h"
#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::tools {

// A named preset of a tool, such as the numbers of a rule. A kind of tool has presets if one of its
// word options is offered as cards (WordOption::Offered::Cards). A preset sets that option and all
// number options. It does not set other word options, such as where a plant stands.
struct ToolCard {
    std::string name {};
    Tool tool {};
};

// Label of the word option that a kind offers as cards, such as "Rule", or null if there is none.
char const* cards_label(ToolKind const& kind);

// Built-in presets of the current tool's kind, applied to the current tool.
std::vector<ToolCard> ready_cards(Tool const& hand);

// The current tool `hand` with the preset `card` applied. Both must be of the same kind.
Tool with_card(Tool const& hand, Tool const& card);

// The tool with the options that a preset sets, and all other options at their defaults. Tools with
// the same preset give equal results.
Tool card_of(Tool const& hand);

// Text of a preset's file: a comment line, then the tool's words as in logs.
std::string card_text(Tool const& tool);

// Parses a preset's file. Fails with a user error that contains the file's name `name`, if the text
// is not a tool whose kind has presets.
Result<Tool> parse_card(ToolKinds kinds, std::string_view text, std::string const& name);

} // namespace tractus::tools
