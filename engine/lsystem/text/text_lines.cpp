#include "engine/lsystem/text/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tractus::lsystem {

bool TextLines::next(std::string_view& line)
{
    if (rest.empty())
        return false;
    auto const end = std::min(rest.find('\n'), rest.size());
    line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    constexpr std::string_view kBlanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    line = line.substr(0, line.find_last_not_of(kBlanks) + 1);
    return true;
}

std::vector<double> numbers_in(std::string_view line)
{
    std::vector<double> result;
    while (true) {
        auto const begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos)
            return result;
        line.remove_prefix(begin);
        double value = 0;
        auto const [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        if (error != std::errc() || !(std::fabs(value) <= 1e12))
            return {};
        result.push_back(value);
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    }
}

std::string_view after_key(std::string_view line, std::string_view key)
{
    auto const value = line.substr(key.size());
    return value.substr(std::min(value.find_first_not_of(" \t"), value.size()));
}

} // namespace tractus::lsystem
