#include "engine/lsystem/notations/lparser_text.h"

#include "engine/lsystem/notations/lparser_turtle.h"
#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <utility>

namespace tractus::lsystem {

namespace {

constexpr std::string_view kLetters = "ABCDEHIJKLMNOPQRSTUVWXYZabcdehijklmnopqrstuvwxyz0123456789";

// Maximum depth of branches with their own factors; deeper branches share the factors of this
// depth.
constexpr int kMaxNesting = 2000;

struct LParserModule {
    char letter = 0;
    std::string number; // Parameter as written; empty if there is none.
};
using LParserString = std::vector<LParserModule>;

struct LParserRule {
    char letter = 0;
    LParserString successor;
};

bool is_number_text(std::string_view text)
{
    double value = 0;
    auto const* const end = text.data() + text.size();
    return std::from_chars(text.data(), end, value).ptr == end && !text.empty();
}

// Returns the name of a file without its folders and without *, so that it cannot end a comment.
std::string comment_name(std::string_view name)
{
    auto result = shown(name.substr(name.rfind('/') + 1));
    std::erase(result, '*');
    return result;
}

class LParserReader {
public:
    explicit LParserReader(std::string const& name)
        : name_(name)
    {
    }

    Result<ImportedModel> read(std::string_view text);

private:
    Result<bool> read_line(std::string_view line);
    Result<bool> read_keyword(std::string_view line);
    Result<void> read_rule(std::string_view line);
    Result<void> set_number(std::size_t index, std::string_view text);
    Result<LParserString> modules_in(std::string_view text);
    Result<void> choose_letters();
    std::string text_of(LParserString const& string) const;
    std::string rule_text(LParserRule const& rule) const;
    std::string homomorphism() const;

    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, line_, what));
    }

    std::string const& name_;
    std::size_t line_ = 0;
    std::array<std::string, 3> numbers_ {
        "1", "45", "100"
    }; // Recursion depth, angle and thickness, as written.
    std::size_t number_count_ = 0;
    std::optional<LParserString> axiom_;
    std::vector<LParserRule> rules_;
    std::map<char, char> letters_; // Letter in cpfg's language for each letter that the model uses.
    char reset_ = 0;               // Letter of the module that sets the factors.
    char push_ = 0;                // Letter of the module that copies the factors for a branch.
    char pop_ = 0;                 // Letter of the module that restores the factors after a branch.
};

Result<LParserString> LParserReader::modules_in(std::string_view text)
{
    LParserString result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        char const c = text[at];
        if (is_blank(c) || c == '_')
            continue;
        if (c != '(') {
            if (c == ')' || static_cast<unsigned char>(c) < ' ' || static_cast<signed char>(c) < 0)
                return error(fmt::format("found '{}' in a string of LParser's letters",
                                         shown(text.substr(at, 1))));
            result.push_back({ c, {} });
            letters_.emplace(c, 0);
            continue;
        }
        auto const close = text.find(')', at);
        auto const number = text.substr(at + 1, close == text.npos ? 0 : close - at - 1);
        if (!is_number_text(trimmed_line(number)))
            return error(fmt::format("found '{}', expected a number in parentheses",
                                     shown(text.substr(at, 12))));
        if (!result.empty())
            result.back().number = trimmed_line(number);
        at = close;
    }
    return result;
}

Result<void> LParserReader::set_number(std::size_t index, std::string_view text)
{
    if (!is_number_text(text))
        return error(fmt::format("found '{}', expected a number", shown(text)));
    numbers_[index] = std::string(text);
    return {};
}

// Reads a rule "X=STRING".
Result<void> LParserReader::read_rule(std::string_view line)
{
    auto const equals = trimmed_line(line.substr(std::min<std::size_t>(line.size(), 1)));
    if (equals.substr(0, 1) != "=")
        return error(fmt::format("found '{}', expected a rule such as A=F[+A]A", shown(line)));
    letters_.emplace(line.front(), 0);
    rules_.push_back({ line.front(), TRY(modules_in(equals.substr(1))) });
    return {};
}

// Reads a line that begins with a keyword of version 5. Returns false for other lines.
Result<bool> LParserReader::read_keyword(std::string_view line)
{
    auto const word = first_name(line);
    auto const rest = trimmed_line(line.substr(word.size()));
    constexpr std::array<std::string_view, 3> kNumbers { "recursion", "angle", "thickness" };
    constexpr std::array<std::string_view, 7> kOthers { "min_thickness", "trope", "rand",
                                                        "poly_limit",    "shape", "color",
                                                        "switch_yz" };
    if (word.size() < 4 || rest.substr(0, 1) == "=")
        return false;
    auto const number = std::find(kNumbers.begin(), kNumbers.end(), word);
    if (number != kNumbers.end()) {
        TRY(set_number(static_cast<std::size_t>(number - kNumbers.begin()), rest));
        number_count_ = kNumbers.size();
    } else if (word == "axiom") {
        axiom_ = TRY(modules_in(rest));
    } else if (word == "rule") {
        TRY(read_rule(rest));
    } else {
        return std::find(kOthers.begin(), kOthers.end(), word) != kOthers.end();
    }
    return true;
}

// Reads a line. Returns false at the end of the model.
Result<bool> LParserReader::read_line(std::string_view written)
{
    auto const line = trimmed_line(written.substr(0, written.find('#')));
    if (line.empty())
        return true;
    if (line == "@")
        return false;
    if (TRY(read_keyword(line)))
        return true;
    if (number_count_ < numbers_.size())
        TRY(set_number(number_count_++, line));
    else if (!axiom_)
        axiom_ = TRY(modules_in(line));
    else
        TRY(read_rule(line));
    return true;
}

// Chooses the letters in cpfg's language: those that can be modules in cpfg stay, all others get a
// free letter.
Result<void> LParserReader::choose_letters()
{
    auto next = kLetters.begin();
    auto const free_letter = [&]() -> char {
        while (next != kLetters.end() && letters_.contains(*next))
            ++next;
        return next == kLetters.end() ? '\0' : *next++;
    };
    for (auto& [letter, module] : letters_) {
        bool const is_kept = std::isalnum(static_cast<unsigned char>(letter))
            || std::string_view("+-&^|.{}![]").find(letter) != std::string_view::npos;
        module = is_kept ? letter : free_letter();
    }
    for (auto* const module : { &reset_, &push_, &pop_ })
        *module = free_letter();
    if (pop_ == 0)
        return fail(Fault::User,
                    fmt::format("{}: the model uses too many letters for one of cpfg's", name_));
    return {};
}

std::string LParserReader::text_of(LParserString const& string) const
{
    std::string text;
    for (auto const& [letter, number] : string) {
        text += letters_.at(letter);
        if (!number.empty() && letter != '[' && letter != ']')
            text += fmt::format("({})", number);
        if (letter == '[')
            text += push_;
        else if (letter == ']')
            text += pop_;
    }
    return text;
}

// Writes a rule in cpfg's language, for the letter without and with a parameter. In LParser
// parameters are text, so the parameter of a replaced letter follows its successor.
std::string LParserReader::rule_text(LParserRule const& rule) const
{
    char const letter = letters_.at(rule.letter);
    auto const empty = [](std::string const& text) { return text.empty() ? "*" : text; };
    auto with_number = rule.successor;
    if (!with_number.empty() && with_number.back().number.empty())
        with_number.back().number = "x";
    return fmt::format("{0} --> {1}\n{0}(x) --> {2}\n", letter, empty(text_of(rule.successor)),
                       empty(text_of(with_number)));
}

std::string LParserReader::homomorphism() const
{
    auto text = fmt::format(
        "homomorphism\n"
        "{0} : {{d = 0; len[0] = 100; turn[0] = {3}; wide[0] = {4};}} 1 --> *\n"
        "{1} : {{if (d < {5}) {{len[d+1] = len[d]; turn[d+1] = turn[d]; wide[d+1] = wide[d];}}\n"
        "    d = d + 1;}} 1 --> *\n"
        "{2} : {{d = d - 1;}} 1 --> *\n",
        reset_, push_, pop_, numbers_[1], numbers_[2], kMaxNesting - 1);
    for (auto const& [letter, plain, with_number] : kLParserCommands)
        if (letters_.contains(letter))
            text += fmt::format("{0} : {1}\n{0}(x) : {2}\n", letters_.at(letter), plain,
                                with_number);
    return text;
}

Result<ImportedModel> LParserReader::read(std::string_view text)
{
    while (!text.empty()) {
        auto const line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        ++line_;
        if (!TRY(read_line(line)))
            break;
    }
    if (!axiom_)
        return error("the file ends before the axiom");
    TRY(choose_letters());
    ImportedModel result;
    result.text
        = fmt::format("/* Made of {0}, a model in LParser's notation. */\n"
                      "Lsystem: 1\nderivation length: {1}\n"
                      "define: {{ array len[{2}]; array turn[{2}]; array wide[{2}]; }}\n"
                      "Start: {{ d = 0; }}\n"
                      "Axiom: {3}{4}\n",
                      comment_name(name_), numbers_[0], kMaxNesting, reset_, text_of(*axiom_));
    for (auto const& rule : rules_)
        result.text += rule_text(rule);
    result.text += homomorphism() + "endlsystem\n";
    result.view = kLParserColors;
    if (letters_.contains('t'))
        result.warnings.push_back(fmt::format(
            "{}: t, LParser's correction for gravity, is left out: branches do not droop", name_));
    return result;
}

} // namespace

Result<ImportedModel> read_lparser_model(std::string const& name, std::string_view text)
{
    return LParserReader(name).read(text);
}

} // namespace tractus::lsystem
