#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/plant/plant.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace tractus::scene {

// A time of the year, as plants show it.
struct Season {
    double month = 7;     // 1 is the first of January, 10.5 the middle of October; below 13.
    double fallen = 0.25; // Share of the leaves fallen this year that are seen on the ground.

    bool operator==(Season const&) const = default;
};

// A month as a number, 1 to below 13, as its English name (its middle), or one of buds, spring,
// summer, autumn, fall, winter and bare. Fails, as the user's fault, listing them.
Result<double> parse_month(std::string_view text);

// A month for people: "mid-October".
std::string month_name(double month);

// How far an organ of that calendar is in its life, on the average, as ages of leaves are
// (leaf_sheet.h). No value: it is not there.
std::optional<double> age_in_season(OrganCalendar const& calendar, double month);

// Sheets of grown leaves by their names.
using LeafSheets = std::map<std::string, std::shared_ptr<lsystem::LeafSheet const>, std::less<>>;

// The names of the sheets that a plant's grown leaves need in that season and that are not there.
std::set<std::string> missing_leaves(Plant const& plant, Season const& season,
                                     LeafSheets const& sheets);

// The plant in that season: what it bears has the age that its calendar says, each organ a little
// apart from the others, or has fallen and lies on the ground below. Segments and nodes stay as
// they are.
//
// Organs without a calendar have one of their kind and material: blades and surfaces of leaves are
// deciduous, petals are there as long as these, needles and all else are evergreen. Grown leaves
// are taken from the sheets; where one is missing, and of organs that are no grown leaves, the
// colour of the material and the size tell the age. Leaves with a `fallen` share are on the plane z
// = 0.
Plant in_season(Plant const& plant, Season const& season, LeafSheets const& sheets);

} // namespace tractus::scene
