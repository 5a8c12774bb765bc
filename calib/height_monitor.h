#pragma once

#include "calib/height_judge.h"
#include "calib/lowest_stop.h"
#include "calib/rig.h"
#include "calib/slow_slip.h"
#include "drivers/reports/height_sample.h"
#include "engine/base/time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace tractus::calib {

// Faults of a height sensor that is still connected.
enum class HeightFaultKind {
    Silence, // No readings arrive.
    // Readings are at an end of the converter's range: an open wiper or cable, a short circuit.
    Rail,
    // The height changed faster than a surface can move (height_judge.h), or was displaced more
    // abruptly than a hand does it, within about 30 ms during a movement or within 20 to 300 ms
    // (slow_slip.h): a slipping string, a loose contact.
    Jump,
    Stuck, // Readings no longer show any noise: a torn or jammed string.
    // The lowest or the highest height that the surface reaches is another one than before: a
    // string that slipped slowly, or an object under the surface (lowest_stop.h).
    Stop,
};
constexpr std::size_t kHeightFaultKinds = 5;

// One fault and its duration. Times are those of the data.
struct HeightFault {
    HeightFaultKind kind = HeightFaultKind::Silence;
    Timestamp begin {};
    Timestamp end {}; // Time at which the fault was last observed.
    // Reading during the fault; for a jump the reading after it, for silence 0.
    std::int32_t counts = 0;
    double speed_mm_per_s = 0; // Greatest speed of a jump.
    // Change of the height in a jump, up or down; 0: not known yet. For a stop, how much higher it
    // is now than before.
    double step_mm = 0;
    bool is_highest_stop = false; // For a stop: the surface's highest, not its lowest.
};

// Total of all faults of one kind.
struct HeightFaultTotal {
    std::size_t count = 0;
    Duration duration {}; // Sum of the faults' durations.
    HeightFault worst {}; // The longest fault; for jumps, the fastest.
};

// Limits between normal use and faults.
struct HeightMonitorLimits {
    // Rail: readings within this share of full scale of an end of the range, for this long.
    double rail_margin = 0.001; // Share of full scale; the end itself always counts.
    Duration rail_after = std::chrono::milliseconds(20);

    // Slow step: a jump that is spread over about 30 ms, which HeightJudge does not doubt. It is
    // reported if the speeds before and after it differ by at most `step_speed_mm_per_s`, and if
    // the height changed by more than the movement explains: by more than `step_mm` plus
    // `step_scatters` times the scatter of the readings. (If a hand begins or ends a movement, the
    // two speeds differ by more.)
    double step_mm = 4;
    double step_scatters = 6;
    double step_speed_mm_per_s = 60;

    // Silence: time without any reading.
    Duration silence_after = std::chrono::milliseconds(250);

    // Stuck: time with exactly the same reading. The longer time is for a sensor that has never
    // shown noise at rest, such as one with 10 bits.
    Duration stuck_after = std::chrono::seconds(5);
    Duration stuck_without_noise_after = std::chrono::seconds(60);
};

// Monitors the height sensor's readings for faults. Samples come in time order. Only the data's
// times are used, so a log shows the same faults as the live sensor. A fault is reported when it
// has lasted for its limit; its `begin` is the time at which it actually began.
class HeightMonitor {
public:
    // The rig's model converts counts to millimetres; outside the model no jumps are reported.
    explicit HeightMonitor(Rig const& rig, HeightMonitorLimits const& limits = {});

    // Adds the sensor's next reading.
    void push(drivers::HeightSample const& sample);

    // True if a reading lies at an end of its range, where it gives no height.
    bool is_on_rail(drivers::HeightSample const& sample) const;

    // Restarts after the sensor was disconnected: its later readings are unrelated to earlier ones.
    void restart_after_reconnection();

    // True if the last reading is implausible so far.
    bool doubts_last() const { return doubts_last_; }

    // Advances the time to `now`, which other data has reached; without these calls, silence after
    // the last reading goes unnoticed. The first call, or the first reading, starts the monitoring.
    void advance(Timestamp now);

    // Returns the present fault; if there are several, the first in the order of HeightFaultKind. A
    // jump counts as present for half a second, a slip or a moved stop for ten.
    std::optional<HeightFault> present() const;

    // Returns the total of all faults of a kind so far, including a present one.
    HeightFaultTotal total(HeightFaultKind kind) const;

    // Mean number of readings per second over the last second of readings; 0 until there are two.
    double rate_hz() const;

private:
    struct Watch {
        std::optional<HeightFault> open {};
        HeightFaultTotal closed {};
    };

    Watch& watch(HeightFaultKind kind) { return watches_[static_cast<std::size_t>(kind)]; }
    Watch const& watch(HeightFaultKind kind) const
    {
        return watches_[static_cast<std::size_t>(kind)];
    }

    void see(HeightFault const& fault);
    void close(HeightFaultKind kind);
    void close_old(HeightFaultKind kind, Duration lasts, Timestamp now);
    std::optional<double> height_of(drivers::HeightSample const& sample) const;
    void watch_rail(drivers::HeightSample const& sample);
    void watch_jump(drivers::HeightSample const& sample);
    void doubt(drivers::HeightSample const& sample, double height_mm);
    void thin_batches(drivers::HeightSample const& sample);
    void watch_step(drivers::HeightSample const& sample);
    void watch_slow_slip(drivers::HeightSample const& sample);
    void watch_stop(drivers::HeightSample const& sample);
    void watch_stuck(drivers::HeightSample const& sample);
    void learn_noise(drivers::HeightSample const& sample);
    void watch_rate(Timestamp time);

    Rig rig_;
    HeightMonitorLimits limits_;
    std::array<Watch, kHeightFaultKinds> watches_ {};

    HeightJudge judge_ {};
    // Readings that the judge has just accepted. A member only to reuse its memory.
    std::vector<HeightJudge::Reading> believed_ {};
    bool doubts_last_ = false;
    std::size_t doubts_ = 0; // Number of readings since the last believed one.
    // Fault to report if the doubted readings turn out to be wrong.
    std::optional<HeightFault> doubted_ {};

    // Time of the last reading, or of the start of the monitoring.
    std::optional<Timestamp> alive_ {};
    std::optional<drivers::HeightSample> last_ {}; // The last reading.
    std::optional<Timestamp> rail_since_ {};       // Time since which readings are at a rail.
    Timestamp same_since_ {}; // Time since which all readings equal the last one.

    // Heights of the last 0.1 s, in which steps are searched.
    struct Height {
        Timestamp time {};
        double mm = 0;
    };
    std::deque<Height> path_ {};

    std::optional<Timestamp> gap_end_ {}; // First reading after the last gap.

    // Believed readings of which only the last of each batch is left, for slow_slip_.
    std::vector<HeightJudge::Reading> thinned_ {};
    std::optional<HeightJudge::Reading> batch_end_ {}; // Last reading of the present batch.
    Timestamp batch_begin_ {};

    SlowSlip slow_slip_ {};
    LowestStop lowest_stop_ {};
    LowestStop highest_stop_ {}; // Gets all heights negated.

    // Noise detection: a change of the reading soon followed by the opposite change, which no hand
    // causes.
    Timestamp last_change_ {};
    int last_change_sign_ = 0;
    std::size_t flickers_ = 0;

    std::deque<Timestamp> recent_ {}; // Times of the readings of the last second.
};

// Describes all faults for the user, one sentence each: what happened, how often and how long, and
// what to check. Empty if there were none. Times in the text count from `start`.
std::vector<std::string> describe_faults(HeightMonitor const& monitor, Timestamp start);

// Describes a present fault in a few words for a status line, which need not be redrawn more than
// once a second: "height sensor silent for 3 s: is it plugged in?"
std::string describe_fault(HeightFault const& fault);

} // namespace tractus::calib
