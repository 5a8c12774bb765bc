#include "engine/lsystem/view/view_organs.h"

#include "engine/lsystem/view/leaf_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace tractus::lsystem {

// Reads the field variants= or age= of a leaf: statement.
static Result<void> read_leaf_field(ViewReader const& reader, LeafOrder& order,
                                    std::string_view part)
{
    auto const equals = std::min(part.find('='), part.size() - 1);
    auto const key = part.substr(0, equals);
    if (key != "variants" && key != "age")
        return reader.error(fmt::format("found '{}', expected variants= or age=", part));
    auto const value = TRY(reader.number(part.substr(equals + 1)));
    if (key == "variants" && !(value >= 1 && value <= 64 && value == std::floor(value)))
        return reader.error(
            fmt::format("found variants={}, expected a whole number, 1 to 64", value));
    if (key == "age" && !(value >= 0 && value <= 1))
        return reader.error(fmt::format("found age={}, expected 0 to 1", value));
    if (key == "variants")
        order.variants = static_cast<int>(value);
    else
        order.age = value;
    return {};
}

Result<void> read_leaf(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.size() < 2 || parts[0].size() != 1)
        return reader.error("expected 'leaf: LETTER GRAMMAR [variants=] [age=]'");
    auto& organs = reader.view.organs;
    auto const organ = std::find_if(organs.begin(), organs.end(),
                                    [&](auto const& other) { return other.letter == parts[0][0]; });
    if (organ == organs.end() || organ->shape.kind != OrganShape::Kind::Blade)
        return reader.error(
            fmt::format("there is no 'organ: {} … kind=blade' above this line", parts[0]));
    auto const material = reader.view.materials.find(organ->shape.material);
    if (material == reader.view.materials.end())
        return reader.error(
            fmt::format("there is no 'material: {}' above this line", organ->shape.material));
    LeafOrder order { .grammar = std::string(parts[1]) };
    for (auto const part : std::vector(parts.begin() + 2, parts.end()))
        TRY(read_leaf_field(reader, order, part));
    auto const name = leaf_sheet_name(order);
    auto const text = reader.include ? reader.include(name)
                                     : Result<std::string>(fail(Fault::User, "nothing grows any"));
    if (!text)
        return reader.error(fmt::format("no leaf for {}: {}", parts[0], text.error().message));
    auto sheet = TRY(parse_leaf_sheet(name, *text));
    organ->leaves.clear();
    for (auto& leaf : sheet.leaves)
        organ->leaves.push_back(leaf_shape(organ->shape, std::move(leaf)));
    material->second.base_color = sheet.mean_color;
    material->second.textures = leaf_textures(sheet);
    return {};
}

// Finds the organ that a statement names by its letter. An earlier statement must define the organ.
static Result<OrganDefinition*> defined_organ(ViewReader& reader, std::string_view letter)
{
    auto& organs = reader.view.organs;
    auto const organ = std::find_if(organs.begin(), organs.end(), [&](auto const& other) {
        return letter.size() == 1 && other.letter == letter[0];
    });
    if (organ == organs.end())
        return reader.error(fmt::format("there is no 'organ: {} …' above this line", letter));
    return &*organ;
}

static Result<void> read_month(ViewReader const& reader, OrganCalendar& calendar,
                               std::string_view part)
{
    struct Month {
        std::string_view key;
        double OrganCalendar::*month;
    };
    static constexpr std::array kMonths { Month { "opens", &OrganCalendar::opens },
                                          Month { "grown", &OrganCalendar::grown },
                                          Month { "turns", &OrganCalendar::turns },
                                          Month { "bare", &OrganCalendar::bare } };
    auto const equals = std::min(part.find('='), part.size() - 1);
    auto const* const month = std::ranges::find(kMonths, part.substr(0, equals), &Month::key);
    if (month == kMonths.end())
        return reader.error(
            fmt::format("found '{}', expected opens=, grown=, turns= or bare=", part));
    calendar.*month->month = TRY(reader.number(part.substr(equals + 1)));
    return {};
}

Result<void> read_calendar(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.size() < 2)
        return reader.error(
            "expected 'calendar: LETTER evergreen' or 'calendar: LETTER opens=... grown=... "
            "turns=... bare=...'");
    auto* const organ = TRY(defined_organ(reader, parts[0]));
    OrganCalendar calendar { .is_evergreen = parts[1] == "evergreen" && parts.size() == 2 };
    if (!calendar.is_evergreen)
        for (auto const part : std::vector(parts.begin() + 1, parts.end()))
            TRY(read_month(reader, calendar, part));
    if (!(calendar.opens >= 1 && calendar.opens < calendar.grown && calendar.grown < calendar.turns
          && calendar.turns < calendar.bare && calendar.bare <= 13))
        return reader.error(fmt::format("found the months {}, {}, {}, {}, expected them to ascend "
                                        "from 1 to 13",
                                        calendar.opens, calendar.grown, calendar.turns,
                                        calendar.bare));
    organ->shape.calendar = calendar;
    for (auto& leaf : organ->leaves)
        leaf.calendar = calendar;
    return {};
}

} // namespace tractus::lsystem
