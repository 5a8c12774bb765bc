#include "app/tools/tool_cards.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::tools {

namespace {

bool is_of_cards(WordOption const& option)
{
    return option.offered == WordOption::Offered::Cards;
}

// Collects the values of all options that a preset sets, in order.
class CardReader final : public OptionVisitor {
public:
    void word(WordOption const& option, int& value) override
    {
        if (is_of_cards(option))
            words.push_back(value);
    }
    void number(NumberOption const&, double& value) override { numbers.push_back(value); }

    std::vector<int> words {};
    std::vector<double> numbers {};
};

class CardSetter final : public OptionVisitor {
public:
    explicit CardSetter(CardReader card)
        : card_(std::move(card))
    {
    }

    void word(WordOption const& option, int& value) override
    {
        if (is_of_cards(option))
            value = card_.words[word_++];
    }
    void number(NumberOption const&, double& value) override { value = card_.numbers[number_++]; }

private:
    CardReader card_;
    std::size_t word_ = 0;
    std::size_t number_ = 0;
};

} // namespace

char const* cards_label(ToolKind const& kind)
{
    for (auto const& chosen : word_settings(Tool(kind)))
        if (is_of_cards(chosen.option))
            return chosen.option.label;
    return nullptr;
}

std::vector<ToolCard> ready_cards(Tool const& hand)
{
    std::vector<ToolCard> cards;
    auto const options = word_settings(hand);
    for (std::size_t i = 0; i < options.size(); ++i)
        if (is_of_cards(options[i].option))
            for (std::size_t word = 0; word < options[i].option.words.size(); ++word)
                cards.push_back({ options[i].option.words[word].label,
                                  with_word(hand, i, static_cast<int>(word)) });
    return cards;
}

Tool with_card(Tool const& hand, Tool const& card)
{
    CardReader reader;
    card.show(reader);
    CardSetter setter(std::move(reader));
    return hand.changed_by(setter);
}

Tool card_of(Tool const& hand)
{
    return with_card(Tool(hand.kind()), hand);
}

std::string card_text(Tool const& tool)
{
    auto const words = words_for(card_of(tool));
    return fmt::format("# A card of tractus: a tool and how it is set.\n{}{}{}\n", words.name,
                       words.arguments.empty() ? "" : " ", words.arguments);
}

Result<Tool> parse_card(ToolKinds kinds, std::string_view text, std::string const& name)
{
    while (text.starts_with('#') || text.starts_with('\n'))
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    auto const line = text.substr(0, text.find_first_of("\r\n"));
    auto const word = line.substr(0, line.find(' '));
    auto const arguments = line.substr(std::min(word.size() + 1, line.size()));
    auto tool = parse_tool(kinds, word, arguments);
    if (!tool)
        return fail(Fault::User, fmt::format("{}: {}", name, tool.error().message));
    if (!cards_label(tool->kind()))
        return fail(Fault::User, fmt::format("{}: \"{}\" is a tool without cards", name, word));
    return card_of(*tool);
}

} // namespace tractus::tools
