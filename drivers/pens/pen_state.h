#pragma once

#include "drivers/pens/pen_fields.h"
#include "drivers/pens/report_rhythm.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>

namespace tractus::drivers {

// Factors and ranges that convert a report's counts into units.
struct PenScale {
    std::int32_t x_minimum = 0;
    std::int32_t y_maximum = 0; // Y in counts at the edge near the user.
    Vec2 mm_per_count = Vec2::Ones();

    bool has_pressure = false;
    std::int32_t pressure_minimum = 0;
    std::int32_t pressure_maximum = 1; // Greater than pressure_minimum.
    // Without a tip switch, the pen touches above this pressure, in counts.
    std::int32_t touch_above = 0;

    bool has_tilt = false;
};

// Deviations of a device from what its reports say. By default there are none.
struct PenHabits {
    // False: reports never say that the pen has left, even if they contain an in-range flag; a
    // silence means it instead (PenState::silence_limit()).
    bool reports_leaving = true;

    // True: the device always reports that the pen leaves, so a silence has other causes, such as a
    // stalled program.
    bool rests_in_silence = false;

    bool second_button_is_eraser = false; // The eraser bit is the second barrel button.
    // The invert bit is the third barrel button, unless it is already set when the pen comes into
    // range.
    bool third_button_is_invert = false;

    // The device may report for a moment that the pen has left although it has not. A pen counts as
    // gone only if it does not return in the same state within this time; 0: every report is
    // believed.
    Duration false_leave {};

    // Height of the sensed coil above the pen's tip; it displaces the reported position of a tilted
    // pen.
    double coil_height_mm = 0;
};

// State machine of a pen, fed with the reports of its device one after another. It serves all
// report formats and applies the known deviations of devices (PenDecoder documents which samples
// are produced).
//
// It reads no clock: equal reports give equal samples.
class PenState {
public:
    // When the pen leaves and the format cannot report it, the tablet stops sending. A hovering pen
    // counts as gone after kSilence, as in Linux's driver; nothing is lost if it only rested. A
    // touching pen of a streaming tablet counts as gone after kSilentIntervals of the tablet's
    // report intervals, but not before kSilence, because the computer may read late.
    static constexpr Duration kSilence = std::chrono::milliseconds(100);
    static constexpr int kSilentIntervals = 16;

    // Silence after which a pen counts as gone although the format can report leaving and has not
    // done so. It is long, so that nothing is lost if the computer stalls for less than this time.
    static constexpr Duration kUnreportedLeaveSilence = std::chrono::seconds(1);

    // A touching pen that rested in silence and is next reported farther away than this was lifted
    // and put down again: a hand that starts to move covers about a millimetre until the next
    // report.
    static constexpr double kFarthestAfterRest_mm = 5;

    explicit PenState(PenHabits const& habits = {})
        : habits_(habits)
    {
    }

    // Returns the sample for a report. No value while the pen is out of range, before its first
    // position is known, and while it is in doubt whether the pen has left.
    std::optional<PenSample> push(Timestamp received, PenFields fields, PenScale const& scale);

    // Returns the sample with which the pen leaves; no value if it is already gone.
    std::optional<PenSample> leave(Timestamp time);

    // Time after the last sample at which leave() is due. No value if the pen is gone, or if it
    // touches and its silence may simply mean rest, as on tablets that report only changes.
    std::optional<Duration> silence_limit() const;

private:
    void undo_habits(PenFields& fields) const;
    bool is_in_doubt(PenSample const& sample);
    bool can_report_leaving() const { return says_in_range_ && habits_.reports_leaving; }
    void follow_rhythm(Timestamp received, PenFields const& fields, PenSample const& sample);
    bool has_moved_during_silence(PenSample const& sample) const;
    std::optional<PenSample> leave_as_reported(Timestamp time);
    bool is_other_tool(PenSample const& sample) const;
    void read_pressure(PenSample& sample, PenFields const& fields, PenScale const& scale) const;
    void place(PenSample& sample, PenFields const& fields, PenScale const& scale) const;

    PenHabits habits_;
    ReportRhythm rhythm_;
    PenSample last_;
    // True if the pen fell silent while touching, and has counted as gone since then.
    bool went_silent_touching_ = false;
    bool has_position_ = false;
    bool says_in_range_ = false; // True if the last report contained an in-range flag.
    // Time at which the device reported that the pen had left.
    std::optional<Timestamp> reported_left_at_;
};

} // namespace tractus::drivers
