#pragma once

#include "drivers/logs/log.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// The heights of a recording as a function of time, so that another converter can be asked what it
// would have read at any instant. Between readings the height goes straight from one to the next;
// before the first and after the last it stands still.
class HeightCurve {
public:
    // The first height sensor of the log; times count from the log's first report. Fails, as the
    // user's fault, if there is none or it has sent nothing.
    static Result<HeightCurve> read(drivers::Log const& log);

    // Height as a share of full scale: 0 to 1.
    double fraction_at(Timestamp time) const;

    // Height as a reading of a converter with this full scale.
    std::int32_t counts_at(Timestamp time, std::int32_t full_scale) const;

    // The recorded sensor's own.
    std::int32_t full_scale() const { return full_scale_; }

    Timestamp end() const { return points_.back().time; }

private:
    struct Point {
        Timestamp time {};
        double fraction = 0;
    };

    HeightCurve(std::vector<Point> points, std::int32_t full_scale);

    std::vector<Point> points_; // Points in time order, at least one.
    std::int32_t full_scale_;
};

} // namespace tractus::sim
