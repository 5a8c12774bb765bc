#include "engine/methods/leaves/grammar_reader.h"

#include "engine/base/random.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace tractus::leaf {

bool is_face(std::string_view word)
{
    return word.size() == 1 && word[0] >= 'A' && word[0] <= 'Z';
}

std::optional<EdgeLabel> take_edge(std::string_view& word)
{
    if (word.empty())
        return std::nullopt;
    char const kind = word[0];
    if (kind == 'O' || kind == 'E') {
        word.remove_prefix(1);
        return kind == 'O' ? EdgeLabel::Origin : EdgeLabel::Extremity;
    }
    int number = 0;
    auto const [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), number);
    if (kind != 'C' || error != std::errc() || number < 1 || number > kMaxSides)
        return std::nullopt;
    word.remove_prefix(static_cast<std::size_t>(end - word.data()));
    return side_label(number);
}

std::optional<EdgeLabel> edge_of(std::string_view word)
{
    auto const edge = take_edge(word);
    return word.empty() ? edge : std::nullopt;
}

Result<char> GrammarReader::face()
{
    auto const place = text.place();
    auto const word = TRY(text.word("a face's letter"));
    if (!is_face(word))
        return text.fail_at(place,
                            fmt::format("\"{}\" is no face: a face has one capital letter", word));
    return word[0];
}

Result<char> GrammarReader::known_face()
{
    auto const place = text.place();
    char const name = TRY(face());
    named_faces.emplace_back(name, place);
    return name;
}

Result<double> GrammarReader::constant(Expression const& expression, TextPlace const& place)
{
    std::vector<double> values(grammar.names.count(), std::nan(""));
    for (auto const& [name, value] : grammar.variables)
        values[name] = value;
    Random random({});
    double const value = expression.value(values, random);
    if (!std::isfinite(value))
        return text.fail_at(place,
                            "this has no finite value, or uses a name that has no "
                            "value yet");
    return value;
}

Result<std::vector<double>> GrammarReader::numbers(std::size_t least, std::size_t most,
                                                   std::string_view what)
{
    auto const place = text.place();
    auto const expressions = TRY(fields());
    if (expressions.size() < least || expressions.size() > most)
        return text.fail_at(place, fmt::format("{}", what));
    std::vector<double> made;
    for (auto const& expression : expressions) {
        if (expression.empty())
            return text.fail_at(place, fmt::format("{}", what));
        made.push_back(TRY(constant(expression, place)));
    }
    return made;
}

Result<Fields> GrammarReader::fields()
{
    Fields made;
    if (!text.take("("))
        return made;
    do {
        if (made.size() == kAttributes)
            return text.fail_here(fmt::format("a face has no more than {} fields", kAttributes));
        made.emplace_back();
        if (text.next_is(",") || text.next_is(")"))
            continue;
        if (text.take("<")) {
            made.back() = TRY(read_expression(text, grammar.names, true));
            TRY(text.expect(">"));
        } else {
            made.back() = TRY(read_expression(text, grammar.names));
        }
    } while (text.take(","));
    TRY(text.expect(")"));
    return made;
}

} // namespace tractus::leaf
