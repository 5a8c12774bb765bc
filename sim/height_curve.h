#pragma once

#include "drivers/logs/log.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// The heights of a recording as a function of time, from which the readings of another converter
// are computed. Heights are interpolated linearly between readings, and constant before the first
// and after the last.
class HeightCurve {
public:
    // Reads the first height sensor of the log; times count from the log's first report. Fails with
    // a user error if there is none or it has sent nothing.
    static Result<HeightCurve> read(drivers::Log const& log);

    // Returns the height as a share of full scale, 0 to 1.
    double fraction_at(Timestamp time) const;

    // Returns the height as a reading of a converter with this full scale.
    std::int32_t counts_at(Timestamp time, std::int32_t full_scale) const;

    // Full scale of the recorded sensor.
    std::int32_t full_scale() const { return full_scale_; }

    Timestamp end() const { return points_.back().time; }

private:
    struct Point {
        Timestamp time {};
        double fraction = 0;
    };

    HeightCurve(std::vector<Point> points, std::int32_t full_scale);

    std::vector<Point> points_; // At least one point, in time order.
    std::int32_t full_scale_;
};

} // namespace tractus::sim
