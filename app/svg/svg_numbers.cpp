#include "app/svg/svg_numbers.h"

#include <charconv>
#include <cmath>

namespace tractus::svg {

std::string_view SvgNumbers::rest()
{
    auto const begin = rest_.find_first_not_of(" \t\r\n\f,");
    rest_.remove_prefix(begin == std::string_view::npos ? rest_.size() : begin);
    return rest_;
}

std::optional<double> SvgNumbers::number()
{
    auto text = rest();
    if (text.starts_with('+'))
        text.remove_prefix(1);
    auto const digits = text.substr(text.starts_with('-') ? 1 : 0);
    if (digits.empty() || digits.find_first_of("0123456789.") != 0) // "inf" and "nan" are refused.
        return std::nullopt;
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value))
        return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
}

std::optional<bool> SvgNumbers::flag()
{
    auto const text = rest();
    if (text.empty() || (text.front() != '0' && text.front() != '1'))
        return std::nullopt;
    rest_.remove_prefix(1);
    return text.front() == '1';
}

std::optional<char> SvgNumbers::symbol()
{
    auto const text = rest();
    if (text.empty())
        return std::nullopt;
    rest_.remove_prefix(1);
    return text.front();
}

} // namespace tractus::svg
