#include "engine/lsystem/notations/book_lines.h"

#include "engine/lsystem/text/placed_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

namespace tractus::lsystem {

namespace {

constexpr auto kNotFound = std::string_view::npos;

struct Spelling {
    std::string_view book;
    std::string_view cpfg;
};

// Replacements of typographic characters anywhere in modules and conditions.
constexpr std::array kTypeset {
    Spelling { "\u2212", "-" },  Spelling { "\u2013", "-" },  Spelling { "\u00a0", " " },
    Spelling { "\u2264", "<=" }, Spelling { "\u2265", ">=" }, Spelling { "\u2260", "!=" },
    Spelling { "\u2227", "&&" }, Spelling { "\u2228", "||" }, Spelling { "\u00ac", "!" },
    Spelling { "\u00b7", "*" },  Spelling { "\u00d7", "*" },
};
// Replacements of the symbols of modules, outside parentheses only.
constexpr std::array kModules {
    Spelling { "'", ";" },
    Spelling { "\u2019", ";" },
    Spelling { "\u2032", ";" },
    Spelling { "$", "@v" },
};

constexpr std::array<std::string_view, 17> kCpfgStatements {
    "lsystem:",          "derivation length:",
    "derivationlength:", "seed:",
    "maximum depth:",    "ring l",
    "ignore:",           "consider:",
    "define:",           "start:",
    "starteach:",        "start each:",
    "endeach:",          "end:",
    "homomorphism",      "endlsystem",
    "decomposition",
};

bool is_number_part(char c)
{
    return is_digit(c) || c == '.';
}

// Returns the index of a character outside parentheses, from index `from` on; kNotFound if there is
// none.
std::size_t find_outside(std::string_view text, char wanted, std::size_t from = 0)
{
    int depth = 0;
    for (auto i = from; i < text.size(); ++i) {
        if (depth == 0 && text[i] == wanted)
            return i;
        depth += text[i] == '(';
        depth -= text[i] == ')' && depth > 0;
    }
    return kNotFound;
}

// Returns the arrow at the beginning of the text; empty if there is none.
std::string_view arrow_at(std::string_view text)
{
    for (std::string_view const arrow : { "-->", "->", "\u2192", "\u27f6", "\u2013>", "\u2014>" })
        if (text.substr(0, arrow.size()) == arrow)
            return text.substr(0, arrow.size());
    return {};
}

// Finds the arrow between predecessor and successor. Since the predecessor is not empty, the arrow
// of the line "-->+", which replaces the symbol - by +, is ->.
std::string_view dividing_arrow(std::string_view line)
{
    for (std::size_t i = 0; i < line.size(); ++i)
        if (auto const arrow = arrow_at(line.substr(i));
            !arrow.empty() && !trimmed_line(line.substr(0, i)).empty())
            return arrow;
    return {};
}

// Returns the text without a label such as "p1 :" or "p_12:".
std::string_view without_label(std::string_view text)
{
    if (text.empty() || !std::islower(static_cast<unsigned char>(text.front())))
        return text;
    auto const digits = text.find_first_not_of("_{", 1);
    if (digits == kNotFound || !is_digit(text[digits]))
        return text;
    auto const end = text.find_first_not_of("0123456789}'", digits);
    auto const colon = text.find_first_not_of(" \t", end);
    if (end == kNotFound || colon == kNotFound || text[colon] != ':')
        return text;
    auto const rest = trimmed_line(text.substr(colon + 1));
    return rest.empty() || rest.front() == '*' ? text : rest;
}

// Removes the probability after an arrow, written .33 or (.33), and returns it; empty if there is
// none.
std::string_view take_probability(std::string_view& successor)
{
    bool const is_bracketed = successor.substr(0, 1) == "(";
    std::size_t const begin = is_bracketed ? 1 : 0;
    auto end = begin;
    while (end < successor.size() && is_number_part(successor[end]))
        ++end;
    auto const number = successor.substr(begin, end - begin);
    auto const behind = end + begin;
    bool const is_closed = !is_bracketed || successor.substr(end, 1) == ")";
    if (number.size() < 2 || number.find('.') == kNotFound || !is_closed
        || behind >= successor.size() || !is_blank(successor[behind]))
        return {};
    successor.remove_prefix(behind);
    return number;
}

// Appends the replacement that the table has for the text at index `at`. Returns the number of
// bytes that are replaced; 0 if the table has no entry for them.
template<std::size_t kCount>
std::size_t append_spelling(std::array<Spelling, kCount> const& table, std::string_view text,
                            std::size_t at, std::string& to)
{
    for (auto const& [book, cpfg] : table)
        if (text.substr(at, book.size()) == book) {
            to += cpfg;
            return book.size();
        }
    return 0;
}

std::string with_typeset_characters(std::string_view text)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        if (auto const size = append_spelling(kTypeset, text, at, result))
            at += size;
        else
            result += text[at++];
    }
    return result;
}

// Returns true if the =, & or | at index `at` is a complete operator, not a part of one such as ==
// or <=.
bool is_single(std::string_view text, std::size_t at)
{
    char const c = text[at];
    char const before = at > 0 ? text[at - 1] : ' ';
    char const behind = at + 1 < text.size() ? text[at + 1] : ' ';
    bool const is_part = c == '=' && (before == '<' || before == '>' || before == '!');
    return before != c && behind != c && !is_part;
}

} // namespace

bool begins_with_word(std::string_view line, std::string_view lower_case_word)
{
    return line.size() >= lower_case_word.size()
        && std::equal(lower_case_word.begin(), lower_case_word.end(), line.begin(),
                      [](char word, char c) {
                          return std::tolower(static_cast<unsigned char>(c))
                              == static_cast<unsigned char>(word);
                      });
}

bool is_cpfg_statement(std::string_view line)
{
    return line.substr(0, 1) == "#"
        || std::any_of(kCpfgStatements.begin(), kCpfgStatements.end(),
                       [&](auto const word) { return begins_with_word(line, word); });
}

std::optional<BookProduction> book_production(std::string_view written)
{
    auto const line = without_label(trimmed_line(written));
    auto const arrow = dividing_arrow(line);
    if (arrow.empty())
        return std::nullopt;
    auto const at = static_cast<std::size_t>(arrow.data() - line.data());
    BookProduction result;
    auto const left = trimmed_line(line.substr(0, at));
    auto const colon = find_outside(left, ':');
    result.predecessor = trimmed_line(left.substr(0, colon));
    if (colon != kNotFound)
        result.condition = trimmed_line(left.substr(colon + 1));
    auto right = trimmed_line(line.substr(at + arrow.size()));
    result.probability = take_probability(right);
    auto const behind = find_outside(right, ':');
    result.successor = trimmed_line(right.substr(0, behind));
    if (behind != kNotFound)
        result.probability = trimmed_line(right.substr(behind + 1));
    return result;
}

std::optional<std::string_view> book_axiom(std::string_view line)
{
    for (std::string_view const word : { "\u03c9", "omega", "axiom", "w" }) {
        if (!begins_with_word(line, word))
            continue;
        auto const rest = trimmed_line(line.substr(word.size()));
        if (rest.substr(0, 1) == ":")
            return trimmed_line(rest.substr(1));
    }
    return std::nullopt;
}

std::optional<BookFigure> book_figure(std::string_view line)
{
    BookFigure result;
    while (!(line = trimmed_line(line)).empty()) {
        auto const equals = line.find('=');
        auto const key = trimmed_line(line.substr(0, equals));
        auto const rest = equals == kNotFound ? line : trimmed_line(line.substr(equals + 1));
        auto const end = std::min(rest.find_first_not_of("0123456789."), rest.size());
        bool const is_steps = key == "n" || key == "N";
        bool const is_angle = key == "\u03b4" || key == "d" || key == "delta" || key == "angle";
        if (equals == kNotFound || end == 0 || (!is_steps && !is_angle))
            return std::nullopt;
        (is_steps ? result.steps : result.angle) = std::string(rest.substr(0, end));
        line = trimmed_line(rest.substr(end));
        for (std::string_view const mark : { "\u00b0", "," })
            if (line.substr(0, mark.size()) == mark)
                line = trimmed_line(line.substr(mark.size()));
    }
    return result.steps.empty() && result.angle.empty() ? std::nullopt : std::optional(result);
}

std::string_view book_without_comment(std::string_view line)
{
    auto const trimmed = trimmed_line(line);
    if (trimmed.substr(0, 2) == "//") {
        // In an indented line, // may mean two rolls that continue a production.
        auto const behind
            = trimmed.substr(std::min(trimmed.find_first_not_of('/'), trimmed.size()));
        bool const is_module = !behind.empty()
            && std::string_view("[]+-&^|{}.!'$").find(behind.front()) != kNotFound;
        return is_blank(line.front()) && is_module ? line : std::string_view();
    }
    for (auto at = line.find(" //"); at != kNotFound; at = line.find(" //", at + 1))
        if (line.substr(at + 3, 1) == " ")
            return line.substr(0, at);
    return line;
}

std::string without_block_comments(std::string_view text)
{
    std::string result(text);
    for (auto begin = result.find("/*"); begin != std::string::npos;
         begin = result.find("/*", begin)) {
        auto const close = result.find("*/", begin + 2);
        auto const end = close == std::string::npos ? result.size() : close + 2;
        std::replace_if(
            result.begin() + static_cast<std::ptrdiff_t>(begin),
            result.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; },
            ' ');
    }
    return result;
}

std::string book_modules(std::string_view written)
{
    auto const text = with_typeset_characters(written);
    std::string result;
    int depth = 0;
    for (std::size_t at = 0; at < text.size();) {
        if (auto const size = depth == 0 ? append_spelling(kModules, text, at, result) : 0) {
            at += size;
            continue;
        }
        char const c = text[at++];
        depth += c == '(';
        depth -= c == ')' && depth > 0;
        bool const is_second_roll
            = depth == 0 && c == '/' && !result.empty() && result.back() == '/';
        result += is_second_roll ? " " : "";
        result += c;
    }
    return result;
}

std::string book_condition(std::string_view written)
{
    auto const text = with_typeset_characters(written);
    bool const has_block = text.find('{') != std::string::npos; // In a block, = is an assignment.
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        bool const is_operator = text[at] == '=' || text[at] == '&' || text[at] == '|';
        result += text[at];
        if (is_operator && !has_block && is_single(text, at))
            result += text[at];
    }
    return result;
}

} // namespace tractus::lsystem
