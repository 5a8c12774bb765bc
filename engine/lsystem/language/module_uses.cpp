#include "engine/lsystem/language/module_uses.h"

#include "engine/base/printable.h"
#include "engine/lsystem/language/turtle_symbols.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace tractus::lsystem {

namespace {

// Maximum number of names to collect, as a protection against hostile models.
constexpr std::size_t kMaxNames = 1000;

bool is_small_letter(char c)
{
    return c >= 'a' && c <= 'z';
}
bool is_capital_letter(char c)
{
    return c >= 'A' && c <= 'Z';
}
bool is_letter_or_digit(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}
// True for the bytes of a UTF-8 character other than its first byte.
bool continues_character(std::size_t byte)
{
    return (byte & 0xc0) == 0x80;
}

// Returns the letters as a list, such as "A, p and e".
std::string listed_letters(std::string_view letters)
{
    std::string text(1, letters.front());
    for (std::size_t i = 1; i < letters.size(); ++i) {
        text += i + 1 == letters.size() ? " and " : ", ";
        text += letters[i];
    }
    return text;
}

// Returns a message that a letter has no effect and, for symbols of books, what to write instead.
std::string describe_letter(std::string_view character)
{
    if (character == "'")
        return "' has no effect here; books print it for the next colour, which is ; here "
               "(--dialect book reads it so)";
    if (character == "$")
        return "$ has no effect here; books print it for rolling until the left side is level, "
               "which is @v here (--dialect book reads it so)";
    if (character == "\u2212" || character == "\u2013" || character == "\u2014")
        return fmt::format("{} is not the keyboard's minus sign and has no effect: write - "
                           "(--dialect book reads it so)",
                           character);
    return fmt::format("{} has no effect: no rule replaces it, and the turtle does not know it",
                       printable(character));
}

// Appends at most kMaxListed of these texts, then a text that counts the others.
void append_listed(std::vector<std::string>& to, std::vector<std::string> texts, char const* what)
{
    auto const told = std::min(texts.size(), ModuleUses::kMaxListed);
    to.insert(to.end(), texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(told));
    if (texts.size() > told)
        to.push_back(fmt::format("{} more {}", texts.size() - told, what));
}

} // namespace

void ModuleUses::begin_string()
{
    string_.clear();
    prefix_.clear();
}

// Returns true if a symbol that began earlier continues with this character: the organ's letter
// after ~, the letter of a query after ?, and the second and third character of an @-symbol.
bool ModuleUses::belongs_to_symbol_before(char symbol, bool has_parameters)
{
    auto const before = std::exchange(prefix_, {});
    if (before == "~")
        return true;
    if (before == "?")
        return kQueryCharacters.find(symbol) != std::string_view::npos;
    if (before == "@") {
        if (!has_parameters && !at_symbol(symbol).thirds.empty())
            prefix_ = { '@', symbol };
        return true;
    }
    return before.size() == 2 && at_symbol(before[1]).thirds.find(symbol) != std::string_view::npos;
}

void ModuleUses::add(char symbol, std::size_t position, bool has_parameters)
{
    used_[index(symbol)] = true;
    if (belongs_to_symbol_before(symbol, has_parameters))
        return;
    calls_systems_ |= symbol == '?' && has_parameters;
    if ((symbol == '@' || symbol == '~' || symbol == '?') && !has_parameters)
        prefix_ = symbol;
    else
        string_.push_back({ symbol, position, has_parameters });
}

// Finds the names in the axiom or successor: looks at runs of letters and digits without blanks or
// parameters between them.
void ModuleUses::end_string()
{
    for (std::size_t begin = 0; begin < string_.size();) {
        auto end = begin + 1;
        while (is_letter_or_digit(string_[begin].symbol) && end < string_.size()
               && is_letter_or_digit(string_[end].symbol) && !string_[end - 1].has_parameters
               && string_[end].position == string_[end - 1].position + 1)
            ++end;
        add_run(begin, end);
        begin = end;
    }
}

// Finds names in a run of letters and digits. A name is a capital letter with at least two small
// letters, as in "FLeaf", or a run of at least three small letters and nothing else. All other
// letters are single modules.
void ModuleUses::add_run(std::size_t begin, std::size_t end)
{
    bool const is_small = std::all_of(string_.begin() + static_cast<std::ptrdiff_t>(begin),
                                      string_.begin() + static_cast<std::ptrdiff_t>(end),
                                      [](Use const& use) { return is_small_letter(use.symbol); });
    for (auto at = begin; at < end;) {
        auto name_end = at + 1;
        if (is_small || is_capital_letter(string_[at].symbol))
            while (name_end < end && is_small_letter(string_[name_end].symbol))
                ++name_end;
        if (name_end - at < 3)
            name_end = at + 1;
        std::string letters;
        for (auto i = at; i < name_end; ++i)
            letters += string_[i].symbol;
        auto& first = first_[index(letters.front())];
        if (letters.size() > 1)
            add_name(std::move(letters), string_[at].position, false);
        else if (!first)
            first = string_[at].position;
        at = name_end;
    }
}

void ModuleUses::add_name(std::string letters, std::size_t position, bool is_predecessor)
{
    auto const known = std::find_if(names_.begin(), names_.end(),
                                    [&](Name const& name) { return name.letters == letters; });
    if (known != names_.end())
        known->is_predecessor |= is_predecessor;
    else if (names_.size() < kMaxNames)
        names_.push_back({ std::move(letters), position, is_predecessor });
}

void ModuleUses::add_predecessor(std::string_view written, std::size_t module_count,
                                 std::size_t position)
{
    std::size_t size = 0;
    while (size < written.size() && (is_letter_or_digit(written[size]) || written[size] == '_'))
        ++size;
    auto const word = written.substr(0, size);
    // A predecessor may also consist of several modules, but these are seldom written like a name:
    // as three or more characters, or as a capital letter with an index.
    bool const is_long = size > 2;
    bool const has_index = size == 2 && is_capital_letter(word[0]) && !is_capital_letter(word[1]);
    if (size == module_count && (is_long || has_index))
        add_name(std::string(word), position, true);
}

bool ModuleUses::is_known(char symbol) const
{
    auto const does = turtle_symbol(symbol).does;
    bool const is_drawn
        = does == SymbolAction::Return ? calls_systems_ : does != SymbolAction::Nothing;
    return is_drawn || known_[index(symbol)];
}

bool ModuleUses::is_whole_known(Name const& name) const
{
    return std::all_of(name.letters.begin(), name.letters.end(),
                       [&](char letter) { return is_known(letter); });
}

// Returns a capital letter that the model does not use for anything else, preferably one of the
// name; 0 if there is none.
char ModuleUses::free_letter(std::string_view name) const
{
    auto const is_free = [&](char letter) {
        return is_capital_letter(letter) && !used_[index(letter)] && !known_[index(letter)]
            && turtle_symbol(letter).does == SymbolAction::Nothing;
    };
    for (char const letter : name)
        if (is_capital_letter(letter) && !first_[index(letter)] && !known_[index(letter)]
            && turtle_symbol(letter).does == SymbolAction::Nothing)
            return letter;
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (is_free(letter))
            return letter;
    return 0;
}

std::string ModuleUses::describe_name(Name const& name) const
{
    char const letter = free_letter(name.letters);
    return fmt::format("{} is read as the modules {}, since names have one letter here{}",
                       name.letters, listed_letters(name.letters),
                       letter ? fmt::format(": call it {}, for example", letter) : "");
}

std::vector<std::string> ModuleUses::warnings(SourceText const& source) const
{
    std::vector<std::string> names;
    for (auto const& name : names_)
        if (name.is_predecessor || !is_whole_known(name))
            names.push_back(
                fmt::format("{}: {}", source.place(name.position), describe_name(name)));
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < first_.size(); ++i) {
        char const symbol = static_cast<char>(i);
        bool const may_separate = has_contexts_ && is_letter_or_digit(symbol);
        if (first_[i] && !is_known(symbol) && !continues_character(i) && !may_separate)
            positions.push_back(*first_[i]);
    }
    std::sort(positions.begin(), positions.end());
    std::vector<std::string> letters;
    for (auto const position : positions) {
        auto const rest = std::string_view(source.text).substr(position);
        letters.push_back(
            fmt::format("{}: {}", source.place(position), describe_letter(first_character(rest))));
    }
    std::vector<std::string> result;
    append_listed(result, std::move(names), "names have several letters");
    append_listed(result, std::move(letters), "letters have no effect");
    return result;
}

} // namespace tractus::lsystem
