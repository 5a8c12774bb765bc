#include "app/controllers/drawing_name.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <optional>

namespace tractus::controllers {

namespace {

// Removes "-" and a number from the end of `name`. Returns false, and changes nothing, if `name`
// does not end so or the number does not have exactly `digits` digits.
bool take_number(std::string_view& name, std::optional<std::size_t> digits = std::nullopt)
{
    auto const last = name.find_last_not_of("0123456789");
    if (last == std::string_view::npos || name[last] != '-')
        return false;
    auto const found = name.size() - last - 1;
    if (found == 0 || found != digits.value_or(found))
        return false;
    name.remove_suffix(found + 1);
    return true;
}

// Removes the time that unnamed_session_path() has appended, and a number after the time.
std::string plant_of(std::string const& stem)
{
    for (bool const numbered : { false, true }) {
        std::string_view plant = stem;
        if (numbered && !take_number(plant))
            continue;
        if (take_number(plant, 4) && take_number(plant, 2) && take_number(plant, 2)
            && take_number(plant, 4) && !plant.empty())
            return std::string(plant);
    }
    return stem;
}

bool is_control(char c)
{
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

} // namespace

std::string name_in_words(std::string stem)
{
    std::replace(stem.begin(), stem.end(), '_', ' ');
    if (!stem.empty())
        stem.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(stem.front())));
    return stem;
}

std::string name_of_drawing(std::filesystem::path const& session, std::string const& given)
{
    return given.empty() ? name_in_words(plant_of(session.stem().string())) : given;
}

Result<std::string> name_as_typed(std::string_view typed)
{
    constexpr std::size_t kMaxBytes = 60;
    auto const first = std::min(typed.find_first_not_of(' '), typed.size());
    auto const name = typed.substr(first, typed.find_last_not_of(' ') + 1 - first);
    if (name.empty())
        return fail(Fault::User, "type a name first: it has at least one letter");
    if (name.size() > kMaxBytes || std::any_of(name.begin(), name.end(), is_control))
        return fail(
            Fault::User,
            fmt::format("a name has at most {} letters, and no tabs or line ends", kMaxBytes));
    return std::string(name);
}

std::string file_name_of(std::string name)
{
    std::replace(name.begin(), name.end(), '/', '-');
    if (!name.empty() && name.front() == '.')
        name.front() = '-';
    return name;
}

} // namespace tractus::controllers
