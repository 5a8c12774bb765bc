#include "engine/lsystem/source_text.h"

#include "engine/lsystem/macro_table.h"
#include "engine/lsystem/placed_text.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus {

namespace {

// What a hostile model may make of itself by files that include themselves.
constexpr int kMaxIncludeNesting = 64;
constexpr std::size_t kMaxFiles = 1000; // Includes of includes double, too.

// The name of a file in the folder of another.
std::string beside(std::string const& file, std::string const& name)
{
    return file.substr(0, file.rfind('/') + 1) + name;
}

class Preprocessor {
public:
    explicit Preprocessor(IncludeReader const& include)
        : include_(include)
    {
    }

    Result<void> add_file(std::string const& name, std::string_view source, int nesting);
    SourceText finish();

private:
    Result<void> add_line(PlacedText const& line, int nesting);
    Result<bool> directive(PlacedText const& line, int nesting);
    Result<void> include_file(PlacedText const& line, std::string_view rest, int nesting);
    Result<void> condition(PlacedText const& line, std::string_view word, std::string_view rest);

    bool active() const
    {
        return std::all_of(conditions_.begin(), conditions_.end(), [](bool on) { return on; });
    }
    tl::unexpected<Error> error(PlacedText const& text, std::size_t index,
                                std::string const& what) const
    {
        return error_in(text, index, files_, what);
    }

    IncludeReader const& include_;
    std::vector<std::string> files_;
    MacroTable macros_ { files_ };
    std::vector<bool> conditions_; // One per open #if.
    PlacedText out_;
};

Result<void> Preprocessor::add_file(std::string const& name, std::string_view source, int nesting)
{
    if (nesting > kMaxIncludeNesting)
        return fail(Fault::User,
                    fmt::format("{}: includes are nested deeper than {}; does it include itself?",
                                name, kMaxIncludeNesting));
    if (files_.size() == kMaxFiles)
        return fail(
            Fault::User,
            fmt::format("{}: there are more than {} includes before this one", name, kMaxFiles));
    files_.push_back(name);
    auto const text = without_comments(source, static_cast<std::uint32_t>(files_.size() - 1));
    auto const open_conditions = conditions_.size();
    std::size_t begin = 0;
    while (begin < text.size()) {
        auto end = std::min(text.characters.find('\n', begin), text.size() - 1) + 1;
        // A definition goes on behind a backslash at the line's end; elsewhere \ is a turtle
        // symbol.
        auto const is_definition
            = trimmed_line(text.characters.substr(begin, end - begin)).substr(0, 1) == "#";
        while (is_definition && end < text.size() && end >= 2 && text.characters[end - 2] == '\\')
            end = std::min(text.characters.find('\n', end), text.size() - 1) + 1;
        PlacedText line;
        line.characters = text.characters.substr(begin, end - begin);
        line.places.assign(text.places.begin() + static_cast<std::ptrdiff_t>(begin),
                           text.places.begin() + static_cast<std::ptrdiff_t>(end));
        TRY(add_line(line, nesting));
        begin = end;
    }
    if (conditions_.size() != open_conditions)
        return error(text, text.size() - 1, "the file ends inside #if, expected #endif");
    return {};
}

Result<void> Preprocessor::add_line(PlacedText const& line, int nesting)
{
    if (TRY(directive(line, nesting))) {
        if (!line.characters.empty() && line.characters.back() == '\n')
            out_.push('\n', line.places.back());
        return {};
    }
    if (!active())
        return {};
    return macros_.expand(line, out_);
}

// Whether the line was a directive.
Result<bool> Preprocessor::directive(PlacedText const& line, int nesting)
{
    auto rest = trimmed_line(line.characters);
    if (rest.empty() || rest.front() != '#')
        return false;
    rest = trimmed_line(rest.substr(1));
    auto const word = first_name(rest);
    rest = trimmed_line(rest.substr(word.size()));
    if (word == "ifdef" || word == "ifndef" || word == "if" || word == "else" || word == "endif") {
        TRY(condition(line, word, rest));
        return true;
    }
    if (word != "define" && word != "undef" && word != "include")
        return false;
    if (!active())
        return true;
    if (word == "define")
        TRY(macros_.define(line, rest));
    else if (word == "undef")
        macros_.undefine(first_name(rest));
    else
        TRY(include_file(line, rest, nesting));
    return true;
}

Result<void> Preprocessor::condition(PlacedText const& line, std::string_view word,
                                     std::string_view rest)
{
    if (word == "else" || word == "endif") {
        if (conditions_.empty())
            return error(line, 0, fmt::format("found #{} without #if", word));
        if (word == "else")
            conditions_.back() = !conditions_.back();
        else
            conditions_.pop_back();
        return {};
    }
    if (word == "if") {
        auto const value = macros_.body(rest);
        if (value.empty() || !std::all_of(value.begin(), value.end(), is_digit))
            return error(line, 0, fmt::format("found #if {}, expected an integer", rest));
        conditions_.push_back(value.find_first_not_of('0') != std::string_view::npos);
        return {};
    }
    bool const defined = macros_.is_defined(first_name(rest));
    conditions_.push_back(defined == (word == "ifdef"));
    return {};
}

Result<void> Preprocessor::include_file(PlacedText const& line, std::string_view rest, int nesting)
{
    auto const close = rest.empty() ? '"' : rest.front() == '<' ? '>' : rest.front();
    if (rest.size() < 3 || (close != '"' && close != '>')
        || rest.find(close, 1) == std::string_view::npos)
        return error(line, 0, fmt::format("found #include {}, expected \"FILE\"", rest));
    auto const name = std::string(rest.substr(1, rest.find(close, 1) - 1));
    if (!include_)
        return error(line, 0, fmt::format("cannot include {}: this model has no folder", name));
    auto const source = include_(name);
    if (!source)
        return error(line, 0, fmt::format("cannot include {}: {}", name, source.error().message));
    return add_file(beside(files_.front(), name), *source, nesting + 1);
}

SourceText Preprocessor::finish()
{
    SourceText result;
    auto const end = out_.places.empty() ? SourcePlace {} : out_.places.back();
    result.files = std::move(files_);
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

} // namespace tractus
