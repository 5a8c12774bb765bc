#include "engine/lsystem/language/cursor.h"

#include "engine/base/printable.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::lsystem {

void Cursor::skip()
{
    auto const& text = source_->text;
    while (at_ < text.size()) {
        char const c = text[at_];
        bool const is_blank = c == ' ' || c == '\t' || c == '\r';
        if (!is_blank && !(c == '\n' && (block_depth_ > 0 || continues_after(at_))))
            return;
        ++at_;
    }
}

bool Cursor::continues_after(std::size_t line_end) const
{
    auto const& text = source_->text;
    auto const begin = line_end + 1;
    if (begin >= text.size() || (text[begin] != '\t' && text[begin] != ' '))
        return false;
    if (text[begin] == '\t')
        return true;
    auto const line = std::string_view(text).substr(begin, text.find('\n', begin) - begin);
    if (line.find_first_not_of(" \t\r") == std::string_view::npos)
        return false;
    bool const has_arrow = line.find("-->") != std::string_view::npos;
    return !(has_arrow && arrow_seen_);
}

char Cursor::peek()
{
    skip();
    return at_ < source_->text.size() ? source_->text[at_] : '\0';
}

bool Cursor::sees(std::string_view text)
{
    skip();
    return rest().substr(0, text.size()) == text;
}

bool Cursor::take(std::string_view text)
{
    bool const found = sees(text);
    if (found)
        at_ += text.size();
    return found;
}

char Cursor::take_character()
{
    return source_->text[at_++];
}

std::string_view Cursor::take_line()
{
    auto const line = rest().substr(0, rest().find('\n'));
    at_ += line.size();
    return line;
}

tl::unexpected<Error> Cursor::unexpected(std::string_view expected)
{
    char const c = peek();
    auto const found = c == '\0' ? std::string("the end of the file")
        : c == '\n'              ? std::string("the end of the line")
                                 : fmt::format("'{}'", printable(first_character(rest())));
    return error_at(at_, fmt::format("found {}, expected {}", found, expected));
}

tl::unexpected<Error> Cursor::error_at(std::size_t position, std::string_view what) const
{
    return fail(Fault::User, fmt::format("{}: {}", source_->place(position), what));
}

} // namespace tractus::lsystem
