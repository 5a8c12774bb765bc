#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <optional>

namespace tractus::calib {

// Watches for a lowest stop that is no longer where it was: a surface that people let down to its
// stop again and again comes to rest at one height there, until the string slips. That is how a
// slip shows that was too slow to be told from a hand.
//
// A surface is let down where it comes from 10 mm higher at least and rests for 0.3 s within half a
// millimetre. The lowest place where that has happened four times, to 0.3 mm, is the stop. It has
// moved if the surface is then let down twice to one place below it; or four times to one place up
// to 30 mm above it, and never to another that low, nor below. What lies under the surface moves
// its stop, too: so it is a question, not a fault.
//
// A pure function of the heights, which come in time order.
class LowestStop {
public:
    struct Moved {
        Timestamp time {}; // When it was told.
        double from_mm = 0;
        double to_mm = 0;
    };

    // The next height; a value when it tells that the stop has moved, once for each time.
    std::optional<Moved> push(Timestamp time, double height_mm);

private:
    // Place to which the surface was let down.
    struct Place {
        double mm = 0; // Mean.
        std::size_t times = 0;

        bool is_at(double height_mm) const;
        void add(double height_mm);
    };

    std::optional<Moved> let_down(Timestamp time, double height_mm);

    std::optional<Timestamp> rests_since_ {};
    double rest_mm_ = 0; // Mean since then …
    std::size_t rest_count_ = 0;
    bool is_rest_told_ = false;
    double highest_mm_ = 0; // Since it was let down.
    double lowest_mm_ = 0;  // Likewise.

    std::optional<Place> stop_ {};
    std::optional<Place> next_ {}; // Where the stop may be now.
};

} // namespace tractus::calib
