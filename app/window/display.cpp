#include "app/window/display.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>

namespace tractus::window {

namespace {

// Relative tolerance between the sizes of a display and of the tablet's active area.
constexpr double kLikeness = 0.05;

bool is_as_large(Vec2 const& one_mm, Vec2 const& other_mm)
{
    return ((one_mm - other_mm).array().abs() <= kLikeness * other_mm.array()).all();
}

std::string small_letters(std::string_view text)
{
    std::string small(text);
    for (auto& letter : small)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return small;
}

// Returns the index of the only display that `accept` accepts; nullopt if it accepts none or
// several.
template<typename Accept>
std::optional<std::size_t> only(std::span<Display const> displays, Accept const& accept)
{
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < displays.size(); ++i) {
        if (!accept(displays[i]))
            continue;
        if (found)
            return std::nullopt;
        found = i;
    }
    return found;
}

} // namespace

std::optional<std::size_t> tablet_display(std::span<Display const> displays, Vec2 const& area_mm)
{
    Vec2 const turned_mm(area_mm.y(), area_mm.x());
    return only(displays, [&](Display const& display) {
        return is_as_large(display.size_mm, area_mm) || is_as_large(display.size_mm, turned_mm);
    });
}

Result<std::size_t> find_display(std::span<Display const> displays, std::string_view which)
{
    std::string list;
    for (std::size_t i = 0; i < displays.size(); ++i) {
        auto const& display = displays[i];
        if (which == std::to_string(i + 1))
            return i;
        list += fmt::format("{}{} {} ({} x {})", i == 0 ? "" : ", ", i + 1, display.name,
                            display.width_px, display.height_px);
    }
    auto const wanted = small_letters(which);
    bool const is_number = wanted.find_first_not_of("0123456789") == std::string::npos;
    auto const found = only(displays, [&](Display const& display) {
        return !is_number && small_letters(display.name).find(wanted) != std::string::npos;
    });
    if (found)
        return *found;
    return fail(Fault::User,
                fmt::format("\"{}\" names no display, or several: give the number or a part of the "
                            "name of one of {}",
                            which, list));
}

} // namespace tractus::window
