#include "sim/simulated_person.h"

#include "calib/height_fit.h"
#include "engine/base/check.h"
#include "engine/base/random.h"
#include "sim/random_streams.h"

#include <algorithm>
#include <cmath>

namespace tractus::sim {

std::vector<SetHeight> set_heights(std::span<double const> aimed_mm, PersonOptions const& options)
{
    Random ruler({ .seed = options.seed, .stream = kRulerStream });
    std::vector<SetHeight> heights;
    for (double const aimed : aimed_mm)
        heights.push_back(
            { .true_mm = aimed + options.ruler_error_mm * ruler.normal(), .stated_mm = aimed });
    if (options.slip)
        heights[options.slip->capture].stated_mm += options.slip->wrong_by_mm;
    return heights;
}

std::vector<calib::HeightCapture> simulate_captures(RigGeometry const& geometry,
                                                    std::span<double const> aimed_mm,
                                                    PersonOptions const& options)
{
    Random noise({ .seed = options.seed, .stream = kHeightNoiseStream });
    std::vector<calib::HeightCapture> captures;
    for (auto const& height : set_heights(aimed_mm, options)) {
        std::vector<drivers::HeightSample> samples;
        for (std::size_t i = 0; i < options.readings; ++i) {
            double const counts
                = ideal_counts(geometry, height.true_mm) + options.noise_counts * noise.normal();
            double const read
                = std::clamp(std::round(counts), 0.0, double(geometry.full_scale_counts));
            samples.push_back({ .time = timestamp_ns(static_cast<std::int64_t>(i) * 2'000'000),
                                .counts = static_cast<std::int32_t>(read),
                                .full_scale = geometry.full_scale_counts });
        }
        auto const capture = calib::capture_at_rest(samples, height.stated_mm);
        // A simulated person holds still and has a working sensor, so the capture always succeeds.
        CHECK(capture);
        captures.push_back(*capture);
    }
    calib::assign_directions(captures);
    return captures;
}

} // namespace tractus::sim
