#pragma once

namespace tractus {

// The year of an organ, in months: 1 is the first of January, 4.5 the middle of April. Ascending,
// all from 1 to 13.
struct OrganCalendar {
    bool is_evergreen = false; // It neither comes nor goes; the months do not count.
    double opens = 4;          // Its bud opens,
    double grown = 5.5;        // it is grown up,
    double turns = 9;          // it begins to age,
    double bare = 11.3;        // and the last of its kind has fallen.

    bool operator==(OrganCalendar const&) const = default;
};

} // namespace tractus
