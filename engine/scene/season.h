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
#include <vector>

namespace tractus::scene {

// A time of the year at which plants are displayed.
struct Season {
    double month = 7;     // 1 is the first of January, 10.5 the middle of October; below 13.
    double fallen = 0.25; // Share of this year's fallen leaves that are displayed on the ground.

    bool operator==(Season const&) const = default;
};

// Parses a month: a number from 1 to below 13, an English month name (the middle of that month), or
// one of buds, spring, summer, autumn, fall, winter and bare. Fails with a user error that lists
// the choices.
Result<double> parse_month(std::string_view text);

// Returns the words that parse_month() reads, in the order of the
// year: first those for seasons, then the months. Omits "fall", another word for autumn.
std::vector<std::string> season_words();

// Returns a description of the month, such as "mid-October".
std::string month_name(double month);

// Returns the average age of an organ with this calendar, on the scale of leaf ages (leaf_sheet.h),
// or no value if the organ is not present in that month.
std::optional<double> age_in_season(OrganCalendar const& calendar, double month);

// Sheets of grown leaves, by name.
using LeafSheets = std::map<std::string, std::shared_ptr<lsystem::LeafSheet const>, std::less<>>;

// Returns the names of the sheets that are needed to show a plant's grown leaves in that season but
// are missing from `sheets`.
std::set<std::string> missing_leaves(Plant const& plant, Season const& season,
                                     LeafSheets const& sheets);

// Returns the plant in a season. Each leaf has the age that its calendar gives, with a small random
// spread, or has fallen and lies on the ground. Segments and nodes are unchanged.
//
// Default calendars, by kind and material: blades and surfaces with a leaf material are deciduous;
// petals are present as long as deciduous leaves; needles and all other organs are evergreen. Grown
// leaves are taken from the sheets. If a sheet is missing, and for leaves that were not grown, age
// is shown by colour and size. Season::fallen is the share of fallen leaves that are displayed, on
// the plane z = 0.
Plant in_season(Plant const& plant, Season const& season, LeafSheets const& sheets);

} // namespace tractus::scene
