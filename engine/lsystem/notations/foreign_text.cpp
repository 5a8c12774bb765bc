#include "engine/lsystem/notations/foreign_text.h"

#include "engine/lsystem/notations/book_lines.h"
#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <initializer_list>
#include <utility>
#include <vector>

namespace tractus::lsystem {

namespace {

// Number of lines that are searched for a statement of a known notation.
constexpr std::size_t kMaxLines = 5000;

std::string_view name_of(Notation notation)
{
    switch (notation) {
    case Notation::LPy:
        return "L-Py (Python)";
    case Notation::LPlusC:
        return "L+C (lpfg)";
    case Notation::GroImp:
        return "XL (GroIMP)";
    case Notation::Houdini:
        return "Houdini's notation";
    case Notation::LParser:
        return "LParser's notation";
    case Notation::Fractint:
        return "Fractint's notation";
    case Notation::JsonText:
        return "JSON";
    }
    return {};
}

std::string in_small_letters(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

// Returns true if the line begins with `word`, followed by optional blanks and one of `marks`.
bool is_word_before(std::string_view line, std::string_view word, std::string_view marks)
{
    if (!line.starts_with(word))
        return false;
    auto const rest = trimmed_line(line.substr(word.size()));
    return !rest.empty() && marks.find(rest.front()) != marks.npos;
}

bool begins_with_any(std::string_view line, std::initializer_list<std::string_view> beginnings)
{
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view beginning) { return line.starts_with(beginning); });
}

// True for rules and axioms of Houdini, such as "rule 1 = A=FA", "rule1: ..." and "premise = A".
bool is_houdini_line(std::string_view line)
{
    if (is_word_before(line, "premise", ":="))
        return true;
    if (!line.starts_with("rule"))
        return false;
    line = trimmed_line(line.substr(4));
    auto const digits = line.find_first_not_of("0123456789");
    return digits != 0 && digits != line.npos && is_word_before(line.substr(digits), "", ":=");
}

bool is_lpy_line(std::string_view line)
{
    return is_word_before(line, "production", ":") || is_word_before(line, "interpretation", ":")
        || begins_with_any(line,
                           { "def ", "import ", "from openalea", "from math import", "nproduce ",
                             "produce ", "extern(", "lsystem." });
}

bool is_lplusc_line(std::string_view line)
{
    bool const ends_in_semicolon = line.back() == ';';
    return line.find("lpfgall.h") != line.npos
        || (ends_in_semicolon
            && ((line.starts_with("module ") && line.find(" extends ") == line.npos)
                || line.starts_with("produce ") || line.starts_with("nproduce ")
                || line.starts_with("axiom:") || line.starts_with("derivation length:")));
}

bool is_groimp_line(std::string_view line)
{
    return line.find("==>") != line.npos || line.starts_with("public void ")
        || line.starts_with("protected void init");
}

bool is_number(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789.") == text.npos;
}

// Returns the line without a comment of LParser, which begins with #.
std::string_view without_number_sign(std::string_view line)
{
    return trimmed_line(line.substr(0, line.find('#')));
}

// Recognises LParser's files by their beginning: three numbers, one per line, for recursion, angle
// and thickness; in version 5 with keywords before them.
class LParserSigns {
public:
    bool sees(std::string_view line)
    {
        auto const text = without_number_sign(line);
        if (text.empty() || is_over_)
            return false;
        bool const is_keyword
            = is_number(trimmed_line(text.substr(std::min(text.find(' '), text.size()))))
            && begins_with_any(text, { "recursion ", "angle ", "thickness " });
        if (!is_number(text) && !is_keyword)
            is_over_ = true;
        else
            ++numbers_;
        return numbers_ == 3;
    }

private:
    int numbers_ = 0;
    bool is_over_ = false; // True after a line that does not give a number.
};

// Recognises Fractint's files by lines such as "Koch1 { ; Adrian Mariano" and "Angle 6".
class FractintSigns {
public:
    bool sees(std::string_view line)
    {
        auto const text = trimmed_line(line.substr(0, line.find(';')));
        bool const has_angle
            = text.starts_with("angle ") && is_number(trimmed_line(text.substr(6)));
        bool const is_sign = is_open_ && has_angle;
        if (!text.empty())
            is_open_ = text.back() == '{' && text.find_first_of(":()") == text.npos;
        return is_sign;
    }

private:
    bool is_open_ = false;
};

class SignReader {
public:
    std::optional<Notation> notation_of(std::string_view line)
    {
        bool const is_first = std::exchange(is_first_, false);
        bool const is_lparser = lparser_.sees(line);
        bool const is_fractint = fractint_.sees(line);
        if (is_lplusc_line(line))
            return Notation::LPlusC;
        if (is_lpy_line(line))
            return Notation::LPy;
        if (is_houdini_line(line))
            return Notation::Houdini;
        if (is_groimp_line(line))
            return Notation::GroImp;
        if (is_lparser || is_fractint)
            return is_lparser ? Notation::LParser : Notation::Fractint;
        if (is_first && (line.front() == '{' || line.starts_with("[{")))
            return Notation::JsonText;
        return std::nullopt;
    }

private:
    LParserSigns lparser_;
    FractintSigns fractint_;
    bool is_first_ = true; // True before the first line has been read.
};

// A line that is neither empty nor a // comment.
struct SignLine {
    std::uint32_t number = 1;
    std::string_view text;
    std::string small; // The line in lower case.
};

std::vector<SignLine> sign_lines(std::string_view text)
{
    std::vector<SignLine> lines;
    for (std::uint32_t number = 1; !text.empty() && number <= kMaxLines; ++number) {
        auto const written = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(written.size() + 1, text.size()));
        auto const line = trimmed_line(written);
        if (!line.empty() && !line.starts_with("//"))
            lines.push_back({ number, line, in_small_letters(line) });
    }
    return lines;
}

std::string remedy(Notation notation, std::string_view file)
{
    switch (notation) {
    case Notation::LParser:
        return fmt::format("\"tractus lsystem import {} -o NAME.l\" makes a model of it", file);
    case Notation::JsonText:
        return "models are texts with \"Lsystem: 1\", an axiom and rules; \"tractus lsystem new\" "
               "writes one to begin with";
    default:
        return "it is not read here; write its rules as A(t) : t > 0 --> F(t)A(t-1), as "
               "\"tractus lsystem new\" shows";
    }
}

} // namespace

std::optional<ForeignText> find_foreign_notation(std::string_view written)
{
    auto const text = without_block_comments(written);
    auto const lines = sign_lines(text);
    bool const has_head = std::any_of(lines.begin(), lines.end(), [](SignLine const& line) {
        return line.small.starts_with("lsystem:");
    });
    SignReader reader;
    for (auto const& line : lines) {
        bool const is_lplusc = line.small.find("lpfgall.h") != std::string::npos;
        if (auto const found = is_lplusc ? Notation::LPlusC
                : has_head               ? std::nullopt
                                         : reader.notation_of(line.small))
            return ForeignText { *found, name_of(*found), line.number, shown(line.text) };
    }
    return std::nullopt;
}

std::string describe_foreign_text(std::string_view file, ForeignText const& foreign)
{
    auto const sign = foreign.notation == Notation::LParser
        ? std::string("the three numbers up to here show")
        : fmt::format("'{}' shows", foreign.sign);
    return fmt::format("{}:{}: this is {}, not cpfg's language, as {}: {}", file, foreign.line,
                       foreign.name, sign, remedy(foreign.notation, file));
}

} // namespace tractus::lsystem
