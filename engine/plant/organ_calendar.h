#pragma once

namespace tractus {

// The yearly cycle of an organ, in months: 1 is the first of January, 4.5 the middle of April. The
// months are ascending, each from 1 to 13.
struct OrganCalendar {
    bool is_evergreen = false; // The organ is present all year; the months are ignored.
    double opens = 4;          // Month of bud burst.
    double grown = 5.5;        // Month in which the organ is fully grown.
    double turns = 9;          // Month in which senescence begins.
    double bare = 11.3;        // Month in which the last organ of this kind has fallen.

    bool operator==(OrganCalendar const&) const = default;
};

} // namespace tractus
