#pragma once

#include "app/tools/tool.h"
#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::tools {

// A way to set a tool that has a name: the numbers of a rule, say. Kinds of tools that have them
// say so by an option that is offered as cards (WordOption). A card sets that option and all
// numbers, and leaves other words, such as where a plant stands, as they are in the hand.
struct ToolCard {
    std::string name {};
    Tool tool {};
};

// The label of the option that a kind offers as cards: "Rule"; null: it has none.
char const* cards_label(ToolKind const& kind);

// The ready cards of the hand's kind, taken into that hand.
std::vector<ToolCard> ready_cards(Tool const& hand);

// The hand with what a card sets. Both are of one kind.
Tool with_card(Tool const& hand, Tool const& card);

// What a card sets in the hand, and nothing else: two hands with the same card give the same.
Tool card_of(Tool const& hand);

// The text of a card's file: a comment, and the tool as logs name it.
std::string card_text(Tool const& tool);

// Fails, as the user's fault, with the file's name, for text that names no tool that has cards.
Result<Tool> parse_card(ToolKinds kinds, std::string_view text, std::string const& name);

} // namespace tractus::tools
