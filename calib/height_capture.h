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

// One height that a person set with a ruler or blocks, and what the sensor read there.
struct HeightCapture {
    double ruler_mm = 0; // Height that the person says.

    // The mean of the readings, and their standard deviation.
    double counts = 0;
    double noise_counts = 0;
    std::size_t readings = 0;

    // How the readings scatter: how many lie in bins of noise_bin_counts() about their mean, the
    // middle one centred on it, outliers in the outermost. An odd number of bins; empty if not
    // known.
    std::vector<int> scatter {};

    // Side from which the carriage came: what hysteresis is seen from.
    enum class From {
        Nowhere, // The first capture, or one at the height of that before.
        Below,
        Above,
    };
    From from = From::Nowhere;
};

// Captures without those of these numbers.
std::vector<HeightCapture> captures_without(std::span<HeightCapture const> captures,
                                            std::span<std::size_t const> left_out);

// The least and the greatest of captures' readings.
struct ReadingRange {
    double low = 0;
    double high = 0;
    double width() const { return high - low; }
    bool operator==(ReadingRange const&) const = default;
};

// Of at least one capture.
ReadingRange reading_range(std::span<HeightCapture const> captures);

// The width of a bin of HeightCapture::scatter for a converter: a count of 12 bits, or as much of a
// finer one.
double noise_bin_counts(std::int32_t full_scale_counts);

// Rulers are read to this: captures closer than it are of one height.
constexpr double kSameHeight_mm = 2;

// How long readings are averaged for a capture.
constexpr Duration kCaptureTime = std::chrono::seconds(1);

// Present reading of the sensor, as a person who calibrates wants to see it.
struct HeightReading {
    double counts = 0; // Mean.
    double noise_counts = 0;
    std::size_t readings = 0;
    std::int32_t full_scale_counts = 0;
    // Whether it is at an end of the converter's range, where nothing is measured.
    bool is_on_rail = false;
    bool is_at_rest = false; // Whether it may be captured.
};

// The readings of about kCaptureTime as one. No value for none.
std::optional<HeightReading> summarize(std::span<drivers::HeightSample const> samples);

// The capture from readings at rest; `from` is the caller's to fill in. Fails, in one sentence that
// says what to do:
// - as the device's fault: fewer than 20 readings, or a gap longer than a quarter of a second;
// - as the user's: readings at either end of the converter's range, readings that jump about (a
//   loose wire), readings that go up or down (the carriage moves or swings).
//
// "At rest" means that the means over an eighth of the time each lie within what their noise makes
// of them, or within a 2048th of full scale, a quarter of a millimetre on half a metre of string.
// The noise is taken from the differences of neighbours (J. von Neumann, "Distribution of the ratio
// of the mean square successive difference to the variance", Ann. Math. Stat. 12, 1941), so that a
// slow movement does not pass for noise.
Result<HeightCapture> capture_at_rest(std::span<drivers::HeightSample const> samples,
                                      double ruler_mm);

// The readings of the last kCaptureTime, as they come.
class RecentReadings {
public:
    void add(drivers::HeightSample const& sample);

    std::optional<HeightReading> reading() const;

private:
    std::deque<drivers::HeightSample> samples_;
};

} // namespace tractus::calib
