#include "engine/lsystem/text/source_text.h"

#include "engine/lsystem/text/macro_table.h"
#include "engine/lsystem/text/open_conditions.h"
#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <fmt/core.h>
#include <optional>
#include <set>
#include <utility>

namespace tractus::lsystem {

namespace {

// Maximum nesting of includes, as a protection against hostile models whose files include
// themselves.
constexpr int kMaxIncludeNesting = 64;
// Maximum number of files, since nested includes can double in number at each level.
constexpr std::size_t kMaxFiles = 1000;

// Returns the path of the file `name` in the folder of the file `file`.
std::string beside(std::string const& file, std::string const& name)
{
    return file.substr(0, file.rfind('/') + 1) + name;
}

// File and line numbers that a #line directive gives to the lines after it.
struct Presumed {
    std::uint32_t file = 0;
    // Difference between these line numbers and the actual ones; may wrap around.
    std::uint32_t added_lines = 0;
};

class Preprocessor {
public:
    explicit Preprocessor(IncludeReader const& include)
        : include_(include)
    {
    }

    Result<void> add_file(std::string const& name, std::string_view source, int nesting);
    SourceText finish();

private:
    Result<void> add_lines(PlacedText const& text, int nesting);
    PlacedText take_line(PlacedText const& text, std::size_t& begin);
    PlacedText take_written_line(PlacedText const& text, std::size_t& begin);
    void warn_of_joined_line(PlacedText const& definition, PlacedText const& line);
    Result<bool> directive(PlacedText const& line, int nesting);
    Result<void> execute_directive(PlacedText const& line, std::string_view word,
                                   std::string_view rest, int nesting);
    Result<void> set_line(PlacedText const& line, std::string_view rest);
    Result<std::uint32_t> add_name(std::string const& name);
    Result<void> include_file(PlacedText const& line, std::string_view rest, int nesting);

    tl::unexpected<Error> error(PlacedText const& text, std::size_t index,
                                std::string const& what) const
    {
        return error_in(text, index, files_, what);
    }

    IncludeReader const& include_;
    std::vector<std::string> files_;
    MacroTable macros_ { files_ };
    OpenConditions conditions_ { macros_, files_ };
    std::string name_;           // Name of the current file.
    std::set<std::string> once_; // Files that are not included again, because of #pragma once.
    std::optional<Presumed> presumed_;
    std::vector<std::string> warnings_;
    PlacedText out_;
};

bool is_directive(std::string_view line)
{
    return trimmed_line(line).substr(0, 1) == "#";
}

// Directives other than conditional ones.
constexpr std::array<std::string_view, 7> kWords { "define",  "undef", "include", "error",
                                                   "warning", "line",  "pragma" };

// Returns the directive that a word after # is probably a misspelling of; empty if there is none. A
// # may also be a turtle symbol, so only separate words of three or more small letters are
// considered.
std::string_view meant_word(std::string_view word, std::string_view behind)
{
    bool const is_alone = behind.empty() || is_blank(behind.front());
    bool const is_small
        = std::all_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (!is_alone || !is_small || word.size() < 3)
        return {};
    auto const condition = nearest_word(word, OpenConditions::kWords);
    return condition.empty() ? nearest_word(word, kWords) : condition;
}

// Returns true if the line is "#define NAME(x)" and nothing else. With a \ at its end, its
// replacement is then on the next line.
bool is_bare_definition(std::string_view line)
{
    auto rest = trimmed_line(line);
    if (rest.substr(0, 1) != "#" || first_name(trimmed_line(rest.substr(1))) != "define")
        return false;
    rest = trimmed_line(trimmed_line(rest.substr(1)).substr(6));
    rest.remove_prefix(first_name(rest).size());
    return rest.substr(0, 1) == "(" && rest.find(')') == rest.size() - 1;
}

// Returns true for a line marker `# 12 "FILE"`, which compilers write instead of `#line 12 "FILE"`.
bool is_line_marker(std::string_view after_hash)
{
    auto const words = trimmed_line(after_hash);
    auto const behind = trimmed_line(words.substr(first_name(words).size()));
    return !words.empty() && is_digit(words.front()) && behind.substr(0, 1) == "\"";
}

Result<void> Preprocessor::add_file(std::string const& name, std::string_view source, int nesting)
{
    if (nesting > kMaxIncludeNesting)
        return fail(Fault::User,
                    fmt::format("{}: includes are nested deeper than {}; does it include itself?",
                                name, kMaxIncludeNesting));
    auto const file = TRY(add_name(name));
    std::optional<SourcePlace> open_comment;
    auto const text = without_comments(source, file, open_comment);
    if (open_comment)
        return fail(Fault::User,
                    fmt::format("{}:{}:{}: the comment that begins here has no */", name,
                                open_comment->line, open_comment->column));
    for (auto const& at : productions_cut_by_comments(source, file))
        warnings_.push_back(fmt::format(
            "{}:{}:{}: // begins a comment here, and the rest of the line is not read; for two "
            "rolls, as books print them, write / / with a blank between (--dialect book reads it "
            "so)",
            name, at.line, at.column));
    auto const around = conditions_.begin_file();
    auto const name_before = std::exchange(name_, name);
    auto const presumed_before = std::exchange(presumed_, std::nullopt);
    TRY(add_lines(text, nesting));
    if (auto const open = conditions_.open_in_file())
        return fail(
            Fault::User,
            fmt::format("{}:{}:{}: this #if has no #endif", name, open->line, open->column));
    conditions_.end_file(around);
    name_ = name_before;
    presumed_ = presumed_before;
    return {};
}

// Adds lines with their macros replaced. As in C, a line that ends inside a macro call continues to
// the end of the call, but never past a directive.
Result<void> Preprocessor::add_lines(PlacedText const& text, int nesting)
{
    constexpr int kMaxCallLines = 1000;
    for (std::size_t begin = 0; begin < text.size();) {
        auto line = take_line(text, begin);
        if (is_directive(line.characters) && TRY(directive(line, nesting))) {
            if (line.characters.back() == '\n')
                out_.push('\n', line.places.back());
            continue;
        }
        if (!conditions_.are_on())
            continue;
        bool is_whole = false;
        for (int i = 0; i < kMaxCallLines && begin < text.size(); ++i) {
            is_whole = TRY(macros_.expand_whole(line, out_));
            auto next = begin;
            auto const more = is_whole ? PlacedText {} : take_line(text, next);
            if (is_whole || is_directive(more.characters))
                break;
            line.append(more, 0, more.size());
            begin = next;
        }
        if (!is_whole)
            TRY(macros_.expand(line, out_));
    }
    return {};
}

PlacedText Preprocessor::take_line(PlacedText const& text, std::size_t& begin)
{
    auto line = take_written_line(text, begin);
    if (presumed_)
        for (auto& place : line.places) {
            place.file = presumed_->file;
            place.line += presumed_->added_lines;
        }
    return line;
}

// Reads a line. If it is a directive that ends in a backslash, the next lines are joined to it;
// elsewhere a \ is a turtle symbol.
PlacedText Preprocessor::take_written_line(PlacedText const& text, std::size_t& begin)
{
    auto const line_end
        = [&] { return std::min(text.characters.find('\n', begin), text.size() - 1) + 1; };
    PlacedText line;
    auto end = line_end();
    line.append(text, begin, end);
    begin = end;
    if (!is_directive(line.characters))
        return line;
    for (auto size = line.size();
         size >= 2 && line.characters.compare(size - 2, 2, "\\\n") == 0 && begin < text.size();
         size = line.size()) {
        line.characters.resize(size - 2);
        line.places.resize(size - 2);
        end = line_end();
        PlacedText next;
        next.append(text, begin, end);
        if (conditions_.are_on())
            warn_of_joined_line(line, next);
        line.append(text, begin, end);
        begin = end;
    }
    return line;
}

// Warns of a definition that ends in the turtle symbol \ and to which, as in C, the next line is
// therefore joined. This is seldom intended.
void Preprocessor::warn_of_joined_line(PlacedText const& definition, PlacedText const& line)
{
    auto const rest = trimmed_line(line.characters);
    if (is_bare_definition(definition.characters))
        return;
    bool const is_statement = rest.find("-->") != std::string_view::npos
        || rest.find("xiom:") != std::string_view::npos || rest.substr(0, 1) == "#";
    if (!rest.empty() && !is_statement)
        return;
    auto const& at = definition.places.front();
    auto const next = rest.empty() ? "an empty one" : fmt::format("'{}'", shown(rest));
    warnings_.push_back(fmt::format(
        "{}:{}:{}: the \\ at the end of this definition joins the next line to it ({}); for the "
        "turtle symbol, write another one behind it, such as \\(a)",
        files_[at.file], at.line, at.column, next));
}

// Executes a directive. Returns false if the line is not a directive.
Result<bool> Preprocessor::directive(PlacedText const& line, int nesting)
{
    auto rest = trimmed_line(line.characters);
    if (rest.empty() || rest.front() != '#')
        return false;
    auto const after_hash = rest.substr(1);
    rest = trimmed_line(after_hash);
    auto const word = first_name(rest);
    auto const behind = rest.substr(word.size());
    rest = trimmed_line(behind);
    if (TRY(conditions_.execute_directive(line, word, rest)))
        return true;
    bool const is_marker = is_line_marker(after_hash);
    bool const is_known = std::find(kWords.begin(), kWords.end(), word) != kWords.end();
    if (auto const meant
        = is_known || is_marker || !conditions_.are_on() ? "" : meant_word(word, behind);
        !meant.empty())
        return error(line, line.characters.find('#'),
                     fmt::format("found '{}', expected '#{}', perhaps",
                                 shown(trimmed_line(line.characters)), meant));
    if (!is_marker && !is_known)
        return false;
    if (conditions_.are_on() && is_marker)
        TRY(set_line(line, trimmed_line(after_hash)));
    else if (conditions_.are_on())
        TRY(execute_directive(line, word, rest, nesting));
    return true;
}

Result<void> Preprocessor::execute_directive(PlacedText const& line, std::string_view word,
                                             std::string_view rest, int nesting)
{
    if (word == "error")
        return error(line, 0, fmt::format("#error {}", shown(rest)));
    if (word == "define")
        return macros_.define(line, rest);
    if (word == "include")
        return include_file(line, rest, nesting);
    if (word == "line")
        return set_line(line, rest);
    if (word == "undef") {
        macros_.undefine(first_name(rest));
    } else if (word == "pragma") {
        if (rest == "once")
            once_.insert(name_);
    } else { // The only directive that remains is #warning.
        auto const& at = line.places[line.characters.find('#')];
        warnings_.push_back(
            fmt::format("{}:{}:{}: #warning {}", files_[at.file], at.line, at.column, shown(rest)));
    }
    return {};
}

// Executes a #line directive, LINE or LINE "FILE". As in C, its macros are replaced first.
Result<void> Preprocessor::set_line(PlacedText const& line, std::string_view rest)
{
    constexpr std::uint32_t kMaxLine = 2'147'483'647;
    PlacedText expanded;
    TRY(macros_.expand(part_of(line, rest), expanded));
    auto const words = trimmed_line(expanded.characters);
    std::uint32_t number = 0;
    auto const* const end = words.data() + words.size();
    auto const [behind, problem] = std::from_chars(words.data(), end, number);
    auto const name = trimmed_line(words.substr(static_cast<std::size_t>(behind - words.data())));
    auto const close = name.find('"', 1);
    if (problem != std::errc() || number > kMaxLine
        || (!name.empty() && (name.front() != '"' || close == std::string_view::npos)))
        return error(line, 0,
                     fmt::format("found #line {}, expected a line's number, and perhaps \"FILE\"",
                                 shown(rest)));
    auto const& at = line.places.back();
    Presumed presumed = presumed_.value_or(Presumed { at.file, 0 });
    presumed.added_lines += number - (at.line + 1);
    if (!name.empty()) {
        auto const file = name.substr(1, close - 1);
        auto const known = std::find(files_.begin(), files_.end(), file);
        presumed.file = known == files_.end() ? TRY(add_name(std::string(file)))
                                              : static_cast<std::uint32_t>(known - files_.begin());
    }
    presumed_ = presumed;
    return {};
}

// Adds a file name for positions in errors. Returns the file's number.
Result<std::uint32_t> Preprocessor::add_name(std::string const& name)
{
    if (files_.size() == kMaxFiles)
        return fail(
            Fault::User,
            fmt::format("{}: there are more than {} includes before this one", name, kMaxFiles));
    files_.push_back(name);
    return static_cast<std::uint32_t>(files_.size() - 1);
}

Result<void> Preprocessor::include_file(PlacedText const& line, std::string_view rest, int nesting)
{
    PlacedText expanded; // The file's name after macro replacement, as a macro may give it.
    if (is_name_start(rest.empty() ? '"' : rest.front())) {
        TRY(macros_.expand(part_of(line, rest), expanded));
        rest = trimmed_line(expanded.characters);
    }
    auto const close = rest.empty() ? '"' : rest.front() == '<' ? '>' : rest.front();
    if (rest.size() < 3 || (close != '"' && close != '>')
        || rest.find(close, 1) == std::string_view::npos)
        return error(line, 0, fmt::format("found #include {}, expected \"FILE\"", shown(rest)));
    auto const name = std::string(rest.substr(1, rest.find(close, 1) - 1));
    auto const file = beside(files_.front(), name);
    if (once_.contains(file))
        return {};
    if (!include_)
        return error(line, 0, fmt::format("cannot include {}: this model has no folder", name));
    auto const source = include_(name);
    if (!source)
        return error(line, 0, fmt::format("cannot include {}: {}", name, source.error().message));
    return add_file(file, *source, nesting + 1);
}

SourceText Preprocessor::finish()
{
    SourceText result;
    auto const end = out_.places.empty() ? SourcePlace {} : out_.places.back();
    result.files = std::move(files_);
    result.warnings = std::move(warnings_);
    result.text = std::move(out_.characters);
    result.places = std::move(out_.places);
    result.places.push_back(end);
    return result;
}

} // namespace

std::string SourceText::place(std::size_t index) const
{
    auto const& at = places[std::min(index, places.size() - 1)];
    return fmt::format("{}:{}:{}", files[at.file], at.line, at.column);
}

Result<SourceText> preprocess(std::string const& name, std::string_view text,
                              IncludeReader const& include)
{
    Preprocessor preprocessor(include);
    TRY(preprocessor.add_file(name, text, 0));
    return preprocessor.finish();
}

} // namespace tractus::lsystem
