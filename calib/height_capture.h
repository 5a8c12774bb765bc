#pragma once

#include "drivers/reports/height_sample.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::calib {

// One height that the user set with a ruler or blocks, and the sensor's readings there.
struct HeightCapture {
    double ruler_mm = 0; // Height given by the user.

    // Mean and standard deviation of the readings.
    double counts = 0;
    double noise_counts = 0;
    std::size_t readings = 0;

    // Histogram of the readings about their mean, in bins of noise_bin_counts(); the middle bin is
    // centred on the mean, and outliers are in the outermost bins. The number of bins is odd; empty
    // if not known.
    std::vector<int> scatter {};

    // Side from which the carriage came, needed to find hysteresis.
    enum class From {
        Nowhere, // The first capture, or one at the height of the previous one.
        Below,
        Above,
    };
    From from = From::Nowhere;
};

// Returns all captures except those at the given indices.
std::vector<HeightCapture> captures_without(std::span<HeightCapture const> captures,
                                            std::span<std::size_t const> left_out);

// The least and the greatest mean reading of several captures.
struct ReadingRange {
    double low = 0;
    double high = 0;
    double width() const { return high - low; }
    bool operator==(ReadingRange const&) const = default;
};

// Returns the range of the captures' mean readings; there must be at least one capture.
ReadingRange reading_range(std::span<HeightCapture const> captures);

// Returns the width of a bin of HeightCapture::scatter: one count of a 12-bit converter, or the
// equivalent for a finer one.
double noise_bin_counts(std::int32_t full_scale_counts);

// Accuracy of setting a height with a ruler: captures closer than this count as one height.
constexpr double kSameHeight_mm = 2;

// Time over which readings are averaged for a capture.
constexpr Duration kCaptureTime = std::chrono::seconds(1);

// The sensor's present reading, as displayed during calibration.
struct HeightReading {
    double counts = 0; // Mean of the readings.
    double noise_counts = 0;
    std::size_t readings = 0;
    std::int32_t full_scale_counts = 0;
    // True if the reading is at an end of the converter's range, where nothing is measured.
    bool is_on_rail = false;
    bool is_at_rest = false; // True if the readings are steady enough for a capture.
};

// Summarises the readings of about kCaptureTime. No value if there are none.
std::optional<HeightReading> summarize(std::span<drivers::HeightSample const> samples);

// Makes a capture from readings at rest; the caller fills in `from`. Fails with a sentence that
// says what to do:
// - with a device error: fewer than 20 readings, or a gap longer than a quarter of a second;
// - with a user error: readings at either end of the converter's range, erratic readings (a loose
//   wire), rising or falling readings (the carriage moves or swings).
//
// "At rest" means that the means over each eighth of the time agree within their noise, or within
// 1/2048 of full scale, a quarter of a millimetre on half a metre of string. The noise is estimated
// from differences of neighbours (J. von Neumann, "Distribution of the ratio of the mean square
// successive difference to the variance", Ann. Math. Stat. 12, 1941), so that slow movement does
// not count as noise.
Result<HeightCapture> capture_at_rest(std::span<drivers::HeightSample const> samples,
                                      double ruler_mm);

// Collects the readings of the last kCaptureTime.
class RecentReadings {
public:
    void add(drivers::HeightSample const& sample);

    std::optional<HeightReading> reading() const;

private:
    std::deque<drivers::HeightSample> samples_;
};

} // namespace tractus::calib
