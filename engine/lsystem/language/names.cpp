#include "engine/lsystem/language/names.h"

#include <algorithm>
#include <fmt/format.h>

namespace tractus::lsystem {

std::optional<std::uint16_t> Names::find_variable(std::string_view name) const
{
    auto const found = std::find(variables.begin(), variables.end(), name);
    if (found == variables.end())
        return std::nullopt;
    return static_cast<std::uint16_t>(found - variables.begin());
}

Result<std::uint16_t> Names::add_variable(std::string name, Cursor const& cursor)
{
    if (variables.size() >= kMax)
        return cursor.error("the L-system has more than 60000 variables");
    variables.push_back(std::move(name));
    return static_cast<std::uint16_t>(variables.size() - 1);
}

void Names::warn(std::string warning)
{
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(std::move(warning));
}

void Names::warn_of(std::string const& thing, std::string warning)
{
    if (warned_of.insert(thing).second)
        warn(std::move(warning));
}

void Names::warn_undefined(std::string const& name, std::string const& place)
{
    if (warned_of.insert(name).second)
        undefined.push_back(fmt::format("{}: {} is not defined; its value is 0", place, name));
}

std::vector<std::string> Names::undefined_warnings() const
{
    constexpr std::size_t kMaxListed = 3;
    auto const told = std::min(undefined.size(), kMaxListed);
    std::vector<std::string> result(undefined.begin(),
                                    undefined.begin() + static_cast<std::ptrdiff_t>(told));
    if (undefined.size() > told)
        result.push_back(fmt::format("{} more names are not defined; their values are 0",
                                     undefined.size() - told));
    return result;
}

} // namespace tractus::lsystem
