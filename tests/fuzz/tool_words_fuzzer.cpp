// Fuzzes the words of tools, cards, least extents and steps, as logs and cards' files contain them.
// The first byte chooses among these; the rest is the text, for lines of a log a name and the rest
// of the line, separated by a zero byte. What can be read must be equal after it was written and
// read again.

#include "app/document/logged_step.h"
#include "app/methods/all_methods.h"
#include "app/tools/min_extent.h"
#include "app/tools/tool_cards.h"
#include "tests/fuzz/fuzz_input.h"

#include <string>

namespace {

using namespace tractus;

tools::Methods const& known_methods()
{
    static auto const all = methods::all_methods();
    return all;
}

void check_tool(tools::Tool const& tool)
{
    auto const kinds = known_methods().tools;
    auto const words = tools::words_for(tool);
    auto const again = tools::parse_tool(kinds, words.name, words.arguments);
    CHECK(again);
    // Words round the angle of a view, so the tools may differ, but not their words.
    auto const twice = tools::words_for(*again);
    CHECK(twice.name == words.name && twice.arguments == words.arguments);
    CHECK(!tool.title().empty());
    auto const selected = tools::words_of_selected_tool(kinds, words.name, words.arguments);
    CHECK(tools::parse_tool(kinds, words.name, selected));
}

void check_card(tools::Tool const& card)
{
    CHECK(tools::cards_label(card.kind()));
    CHECK(tools::card_of(card) == card);
    auto const again = tools::parse_card(known_methods().tools, tools::card_text(card), "again");
    CHECK(again);
    CHECK(*again == card);
    for (auto const& [name, ready] : tools::ready_cards(card))
        check_tool(ready);
}

void check_step(FuzzInput input)
{
    auto const name = input.take_part();
    auto const read = document::parse_step(name, input.text(), known_methods().edits);
    if (!read || !is_read(*read))
        return;
    auto const& step = **read;
    auto const words = document::words_for(
        { .status = std::string(), .what = step.what, .edits = step.edits }, step.strokes_before);
    auto const again = document::parse_step(words.name, words.arguments, known_methods().edits);
    CHECK(again && *again);
    CHECK((*again)->strokes_before == step.strokes_before);
    auto const twice = document::words_for(
        { .status = std::string(), .what = (*again)->what, .edits = (*again)->edits },
        step.strokes_before);
    CHECK(twice.name == words.name && twice.arguments == words.arguments);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    FuzzInput input(data, size);
    switch (input.take_byte() % 4) {
    case 0: {
        auto const name = input.take_part();
        if (auto const tool = tools::parse_tool(known_methods().tools, name, input.text());
            is_read(tool))
            check_tool(*tool);
        break;
    }
    case 1:
        if (auto const card = tools::parse_card(known_methods().tools, input.text(), "fuzz");
            is_read(card))
            check_card(*card);
        break;
    case 2:
        if (auto const extents = tools::parse_min_extents(input.text()); is_read(extents)) {
            auto const again = tools::parse_min_extents(tools::print_min_extents(*extents));
            CHECK(again);
            CHECK(*again == *extents);
        }
        break;
    default:
        check_step(input);
    }
    return 0;
}
