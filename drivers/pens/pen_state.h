#pragma once

#include "drivers/pens/pen_fields.h"
#include "drivers/pens/report_rhythm.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>

namespace tractus::drivers {

// Scale that turns the counts of a report into units: the ranges that the device declares, and the
// size of one count.
struct PenScale {
    std::int32_t x_minimum = 0;
    std::int32_t y_maximum = 0; // Maximum at the edge near the user.
    Vec2 mm_per_count = Vec2::Ones();

    bool has_pressure = false;
    std::int32_t pressure_minimum = 0;
    std::int32_t pressure_maximum = 1; // Above the minimum.
    // Where no tip switch tells, the pen touches above this pressure.
    std::int32_t touch_above = 0;

    bool has_tilt = false;
};

// How a device differs from what its reports say. The default is a device that does not.
struct PenHabits {
    // False: the format has no way to say that the pen has left, whatever its reports say of being
    // in range; silence stands for it (PenState::silence_limit()).
    bool reports_leaving = true;

    // The device always says that the pen leaves: silence has other reasons, such as a program that
    // stalls.
    bool rests_in_silence = false;

    bool second_button_is_eraser = false; // The eraser's bit is the second barrel button.
    // The bit of the inverted pen is the third barrel button, unless the pen comes into range so.
    bool third_button_is_invert = false;

    // The pen is reported as gone for a moment though it is there. It counts as gone if it does not
    // come back as it was within this time; 0: believe each report.
    Duration false_leave {};

    // The tablet sees a coil this far up the pen, so that a tilted pen seems to be beside its tip.
    double coil_height_mm = 0;
};

// Follows a pen, as its device's reports tell of it one after another. It is the one state machine
// for every format, and for what devices are known to do (PenDecoder says which samples come out).
//
// It reads no clock: the same reports give the same samples.
class PenState {
public:
    // Formats that cannot say that the pen has left stop sending. A pen that hovers is away after
    // this time, as with Linux's driver: nothing is lost if it only rested. One that touches and
    // belongs to a tablet that streams is away after kSilentIntervals of the tablet's own, and no
    // sooner than after this time, since the machine that reads may be late, too.
    static constexpr Duration kSilence = std::chrono::milliseconds(100);
    static constexpr int kSilentIntervals = 16;

    // A streaming tablet's format can say that the pen leaves, and it has stopped without saying
    // so. No less: a reading machine that stalls for less loses nothing.
    static constexpr Duration kUnsaidSilence = std::chrono::seconds(1);

    // A pen that touches, rests in silence, and is next reported farther away than this has been
    // lifted and put down there: a hand that starts to move goes a millimetre until the next
    // report.
    static constexpr double kFarthestAfterRest_mm = 5;

    explicit PenState(PenHabits const& habits = {})
        : habits_(habits)
    {
    }

    // No value while the pen is away, before its first place is known, and while it is in doubt
    // whether the pen has left.
    std::optional<PenSample> push(Timestamp received, PenFields fields, PenScale const& scale);

    // The sample in which the pen leaves; no value if it is away already.
    std::optional<PenSample> leave(Timestamp time);

    // How long after the last sample leave() is due. No value: the pen is away; or it touches, and
    // nothing shows that its silence means more than rest, as on tablets that report changes only.
    std::optional<Duration> silence_limit() const;

private:
    void undo_habits(PenFields& fields) const;
    bool is_in_doubt(PenSample const& sample);
    bool can_say_leaving() const { return says_in_range_ && habits_.reports_leaving; }
    void follow_rhythm(Timestamp received, PenFields const& fields, PenSample const& sample);
    bool has_moved_unseen(PenSample const& sample) const;
    std::optional<PenSample> leave_as_said(Timestamp time);
    bool is_other_tool(PenSample const& sample) const;
    void read_pressure(PenSample& sample, PenFields const& fields, PenScale const& scale) const;
    void place(PenSample& sample, PenFields const& fields, PenScale const& scale) const;

    PenHabits habits_;
    ReportRhythm rhythm_;
    PenSample last_;
    // The pen fell silent while it touched, and counts as away since then.
    bool went_silent_touching_ = false;
    bool has_position_ = false;
    bool says_in_range_ = false;          // The last report did, one way or the other.
    std::optional<Timestamp> maybe_left_; // When the device said that the pen is gone.
};

} // namespace tractus::drivers
