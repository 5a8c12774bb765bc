#include "engine/lsystem/source_text.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <map>
#include <optional>
#include <span>

namespace tractus {

namespace {

// What a hostile model may make of itself: macros that double at each use, files that include
// themselves.
constexpr std::size_t kMaxTextSize = std::size_t { 16 } << 20;
constexpr int kMaxNesting = 64;
constexpr std::size_t kMaxFiles = 1000; // Includes of includes double, too.

struct Text {
    std::string characters;
    std::vector<SourcePlace> places;

    void push(char character, SourcePlace place)
    {
        characters.push_back(character);
        places.push_back(place);
    }
    void append(Text const& other)
    {
        characters += other.characters;
        places.insert(places.end(), other.places.begin(), other.places.end());
    }
    std::size_t size() const { return characters.size(); }
};

struct Macro {
    bool has_parameters = false;
    std::vector<std::string> parameters;
    std::string body;
};

bool is_name_start(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool is_name_part(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
bool is_digit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c));
}
bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

// The end of the preprocessing token (C11 6.4) at `begin`: a name, a number with its suffixes, a
// string, or one character. Macro names inside numbers and strings are not replaced.
std::size_t token_end(std::string_view text, std::size_t begin)
{
    auto end = begin + 1;
    if (is_name_start(text[begin])) {
        while (end < text.size() && is_name_part(text[end]))
            ++end;
    } else if (is_digit(text[begin])
               || (text[begin] == '.' && end < text.size() && is_digit(text[end]))) {
        while (end < text.size() && (is_name_part(text[end]) || text[end] == '.'))
            ++end;
    } else if (text[begin] == '"') {
        while (end < text.size() && text[end] != '"' && text[end] != '\n')
            ++end;
        end = std::min(end + 1, text.size());
    }
    return end;
}

// A comment becomes one blank, so a rule may go on behind one that spans lines.
Text without_comments(std::string_view source, std::uint32_t file)
{
    Text result;
    SourcePlace place { file, 1, 1 };
    std::size_t i = 0;
    auto const advance = [&] {
        if (source[i++] == '\n') {
            ++place.line;
            place.column = 1;
        } else {
            ++place.column;
        }
    };
    while (i < source.size()) {
        if (source.substr(i, 2) == "//") {
            while (i < source.size() && source[i] != '\n')
                advance();
        } else if (source.substr(i, 2) == "/*") {
            result.push(' ', place);
            auto const end = std::min(source.find("*/", i + 2), source.size() - 2) + 2;
            while (i < end)
                advance();
        } else {
            if (source[i] != '\r')
                result.push(source[i], place);
            advance();
        }
    }
    return result;
}

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
    Result<void> add_line(Text const& line, int nesting);
    Result<bool> directive(Text const& line, int nesting);
    Result<void> define(Text const& line, std::string_view rest);
    Result<void> include_file(Text const& line, std::string_view rest, int nesting);
    Result<void> condition(Text const& line, std::string_view word, std::string_view rest);
    Result<void> expand(Text const& text, Text& out, std::vector<std::string>& active) const;
    Result<std::size_t> expand_call(Macro const& macro, std::string const& name, Text const& text,
                                    std::size_t open, Text& out,
                                    std::vector<std::string>& active) const;
    Result<void> expand_body(std::string const& name, Text const& body, Text& out,
                             std::vector<std::string>& active) const;

    bool active() const
    {
        return std::all_of(conditions_.begin(), conditions_.end(), [](bool on) { return on; });
    }
    tl::unexpected<Error> error(Text const& text, std::size_t index, std::string const& what) const
    {
        auto const place = index < text.places.size() ? text.places[index] : SourcePlace {};
        return fail(
            Fault::User,
            fmt::format("{}:{}:{}: {}", files_[place.file], place.line, place.column, what));
    }

    IncludeReader const& include_;
    std::vector<std::string> files_;
    std::map<std::string, Macro, std::less<>> macros_;
    std::vector<bool> conditions_; // One per open #if.
    Text out_;
};

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && (is_blank(text.back()) || text.back() == '\n'))
        text.remove_suffix(1);
    return text;
}

std::string_view first_name(std::string_view text)
{
    std::size_t end = 0;
    while (end < text.size() && is_name_part(text[end]))
        ++end;
    return text.substr(0, end);
}

Result<void> Preprocessor::add_file(std::string const& name, std::string_view source, int nesting)
{
    if (nesting > kMaxNesting)
        return fail(Fault::User,
                    fmt::format("{}: includes are nested deeper than {}; does it include itself?",
                                name, kMaxNesting));
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
            = trimmed(text.characters.substr(begin, end - begin)).substr(0, 1) == "#";
        while (is_definition && end < text.size() && end >= 2 && text.characters[end - 2] == '\\')
            end = std::min(text.characters.find('\n', end), text.size() - 1) + 1;
        Text line;
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

Result<void> Preprocessor::add_line(Text const& line, int nesting)
{
    if (TRY(directive(line, nesting))) {
        if (!line.characters.empty() && line.characters.back() == '\n')
            out_.push('\n', line.places.back());
        return {};
    }
    if (!active())
        return {};
    std::vector<std::string> active_macros;
    return expand(line, out_, active_macros);
}

// Whether the line was a directive.
Result<bool> Preprocessor::directive(Text const& line, int nesting)
{
    auto rest = trimmed(line.characters);
    if (rest.empty() || rest.front() != '#')
        return false;
    rest = trimmed(rest.substr(1));
    auto const word = first_name(rest);
    rest = trimmed(rest.substr(word.size()));
    if (word == "ifdef" || word == "ifndef" || word == "if" || word == "else" || word == "endif") {
        TRY(condition(line, word, rest));
        return true;
    }
    if (word != "define" && word != "undef" && word != "include")
        return false;
    if (!active())
        return true;
    if (word == "define")
        TRY(define(line, rest));
    else if (word == "undef")
        macros_.erase(std::string(first_name(rest)));
    else
        TRY(include_file(line, rest, nesting));
    return true;
}

Result<void> Preprocessor::condition(Text const& line, std::string_view word, std::string_view rest)
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
        auto const macro = macros_.find(rest);
        auto const value = macro == macros_.end() ? std::string(rest) : macro->second.body;
        if (value.empty() || !std::all_of(value.begin(), value.end(), is_digit))
            return error(line, 0, fmt::format("found #if {}, expected an integer", rest));
        conditions_.push_back(value.find_first_not_of('0') != std::string::npos);
        return {};
    }
    bool const defined = macros_.find(first_name(rest)) != macros_.end();
    conditions_.push_back(defined == (word == "ifdef"));
    return {};
}

Result<void> Preprocessor::define(Text const& line, std::string_view rest)
{
    auto const name = first_name(rest);
    if (name.empty() || !is_name_start(name.front()))
        return error(line, 0, fmt::format("found #define {}, expected a name", rest));
    Macro macro;
    rest.remove_prefix(name.size());
    if (!rest.empty() && rest.front() == '(') {
        auto const close = rest.find(')');
        if (close == std::string_view::npos)
            return error(line, 0, fmt::format("#define {}( has no closing parenthesis", name));
        macro.has_parameters = true;
        auto list = rest.substr(1, close - 1);
        while (!trimmed(list).empty()) {
            auto const comma = std::min(list.find(','), list.size());
            macro.parameters.emplace_back(trimmed(list.substr(0, comma)));
            list.remove_prefix(std::min(comma + 1, list.size()));
        }
        rest.remove_prefix(close + 1);
    }
    macro.body = trimmed(rest);
    for (std::size_t i = 0; i + 1 < macro.body.size(); ++i)
        if (macro.body[i] == '\\' && macro.body[i + 1] == '\n')
            macro.body[i] = macro.body[i + 1] = ' ';
    macros_.insert_or_assign(std::string(name), std::move(macro));
    return {};
}

Result<void> Preprocessor::include_file(Text const& line, std::string_view rest, int nesting)
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

Result<void> Preprocessor::expand(Text const& text, Text& out,
                                  std::vector<std::string>& active) const
{
    if (out.size() > kMaxTextSize)
        return error(text, 0, "macros make more than 16 MB of text here");
    std::string_view const characters = text.characters;
    for (std::size_t i = 0; i < characters.size();) {
        auto const end = token_end(characters, i);
        auto const macro = is_name_start(characters[i])
            ? macros_.find(characters.substr(i, end - i))
            : macros_.end();
        if (macro != macros_.end()
            && std::find(active.begin(), active.end(), macro->first) == active.end()) {
            if (!macro->second.has_parameters) {
                Text body { macro->second.body, {} };
                body.places.assign(body.size(), text.places[i]);
                TRY(expand_body(macro->first, body, out, active));
                i = end;
                continue;
            }
            auto open = end;
            while (open < characters.size() && is_blank(characters[open]))
                ++open;
            if (open < characters.size() && characters[open] == '(') {
                i = TRY(expand_call(macro->second, macro->first, text, open, out, active));
                continue;
            }
        }
        for (; i < end; ++i)
            out.push(characters[i], text.places[i]);
    }
    return {};
}

Result<void> Preprocessor::expand_body(std::string const& name, Text const& body, Text& out,
                                       std::vector<std::string>& active) const
{
    if (active.size() > static_cast<std::size_t>(kMaxNesting))
        return error(body, 0, fmt::format("macros are nested deeper than {}", kMaxNesting));
    active.push_back(name);
    TRY(expand(body, out, active));
    active.pop_back();
    return {};
}

// Replaces a macro with parameters whose call's parenthesis is at `open`; returns the call's end.
Result<std::size_t> Preprocessor::expand_call(Macro const& macro, std::string const& name,
                                              Text const& text, std::size_t open, Text& out,
                                              std::vector<std::string>& active) const
{
    std::vector<Text> arguments(1);
    int depth = 0;
    auto i = open;
    for (; i < text.size(); ++i) {
        char const c = text.characters[i];
        if (c == '(' && ++depth == 1)
            continue;
        if (c == ')' && --depth == 0)
            break;
        if (c == ',' && depth == 1)
            arguments.emplace_back();
        else
            arguments.back().push(c, text.places[i]);
    }
    if (depth != 0)
        return error(text, open,
                     fmt::format("the call of macro {} has no closing parenthesis", name));
    if (arguments.size() != std::max<std::size_t>(macro.parameters.size(), 1))
        return error(text, open,
                     fmt::format("macro {} has {} parameters, found {} arguments", name,
                                 macro.parameters.size(), arguments.size()));
    Text body;
    for (std::size_t k = 0; k < macro.body.size();) {
        auto const end = token_end(macro.body, k);
        auto const parameter = std::find(macro.parameters.begin(), macro.parameters.end(),
                                         macro.body.substr(k, end - k));
        if (parameter != macro.parameters.end())
            TRY(expand(arguments[static_cast<std::size_t>(parameter - macro.parameters.begin())],
                       body, active));
        else
            for (auto j = k; j < end; ++j)
                body.push(macro.body[j], text.places[open]);
        k = end;
    }
    TRY(expand_body(name, body, out, active));
    return i + 1;
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
