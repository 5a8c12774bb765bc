#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <optional>

namespace tractus::calib {

// Detects that the lowest stop has moved: a surface that is let down to its stop again and again
// comes to rest, or turns, at one height, until the string slips. This reveals a slip that cannot
// be distinguished from a hand's movement. With all heights negated, it finds the highest stop.
//
// A surface counts as let down if it comes from at least 10 mm higher and then rests for 0.3 s
// within half a millimetre, or goes up again by at least 10 mm. The lowest place where this
// happened three times, within 0.3 mm, is the stop. It has moved if the surface is then let down
// twice to one place below it; or four times to one place up to 30 mm above it, and meanwhile never
// to the old stop or below. An object under the surface also moves its stop, so this is a question
// to the user, not a fault.
//
// The result depends only on the heights, which come in time order.
class LowestStop {
public:
    struct Moved {
        Timestamp time {}; // Time at which the move was detected.
        double from_mm = 0;
        double to_mm = 0;
    };

    // Adds a height. Returns a value, once for each move, when it shows that the stop has moved.
    std::optional<Moved> push(Timestamp time, double height_mm);

private:
    // A place at which the surface came to rest, or turned, after it was lowered.
    struct Place {
        double mm = 0; // Mean height of the surface here.
        std::size_t times = 0;

        bool is_at(double height_mm) const;
        void add(double height_mm);
    };

    // Returns the place where the surface has just been let down, if it has.
    std::optional<double> place_of_rest(Timestamp time, double height_mm);
    std::optional<double> place_of_turn(Timestamp time, double height_mm);
    std::optional<Moved> let_down(Timestamp time, double height_mm);

    std::optional<Timestamp> rests_since_ {};
    double rest_mm_ = 0; // Mean height since rests_since_.
    std::size_t rest_count_ = 0;
    bool is_rest_reported_ = false;

    Timestamp last_time_ {};
    double smooth_mm_ = 0;  // Mean height over about the last 3 ms.
    double highest_mm_ = 0; // Greatest smooth_mm_ since the surface was last let down.
    double valley_mm_ = 0;  // Least smooth_mm_ since the highest.
    double lowest_mm_ = 0;  // Least height since the surface was last let down.

    std::optional<Place> stop_ {};
    std::optional<Place> next_ {}; // Candidate for the new place of the stop.
};

} // namespace tractus::calib
