#include "engine/lsystem/view/view_reader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

void ViewReader::warn(std::string const& what)
{
    view.warnings.push_back(fmt::format("{}: {}", source.place(at), what));
}

tl::unexpected<Error> ViewReader::error(std::string const& what) const
{
    return fail(Fault::User, fmt::format("{}: {}", source.place(at), what));
}

Result<double> ViewReader::number(std::string_view text) const
{
    if (auto const value = lsystem::number(trimmed(text)))
        return *value;
    return error(fmt::format("found '{}', expected a number", trimmed(text)));
}

Result<Vec3> ViewReader::vector(std::string_view text) const
{
    auto const parts = words(text, " \t,");
    if (parts.size() != 3)
        return error(fmt::format("found '{}', expected three numbers", text));
    Vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = TRY(number(parts[static_cast<std::size_t>(i)]));
    return result;
}

std::optional<std::string> ViewReader::file(std::string_view what, std::string const& name,
                                            std::string_view instead)
{
    auto text = include ? include(name)
                        : Result<std::string>(fail(Fault::User, "this model has no folder"));
    if (text)
        return *std::move(text);
    warn(fmt::format("cannot read the {} {} ({}); {}", what, name, text.error().message, instead));
    return std::nullopt;
}

std::string_view trimmed(std::string_view text)
{
    auto const is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)); };
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> words(std::string_view text, std::string_view separators)
{
    std::vector<std::string_view> result;
    while (true) {
        auto const begin = text.find_first_not_of(separators);
        if (begin == std::string_view::npos)
            return result;
        text.remove_prefix(begin);
        auto const end = std::min(text.find_first_of(separators), text.size());
        result.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

std::optional<double> number(std::string_view text)
{
    if (!text.empty() && text.front() == '+')
        text.remove_prefix(1);
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace tractus::lsystem
