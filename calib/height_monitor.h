#pragma once

#include "calib/height_judge.h"
#include "calib/lowest_stop.h"
#include "calib/rig.h"
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

// Faults of a height sensor that goes on being a device.
enum class HeightFaultKind {
    Silence, // No reading comes.
    Rail,    // Readings lie at an end of the converter's range: an open wiper or cable, a short.
    Jump,  // The height changed more suddenly than a surface can (height_judge.h), or stepped aside
           // in the midst of a movement: a slipping string, a loose contact.
    Stuck, // The reading does not even show its noise any more: a torn or jammed string.
    Stop,  // The surface is let down to another height than it used to be: a string that slipped
           // slowly, or something that lies under it (lowest_stop.h).
};
constexpr std::size_t kHeightFaultKinds = 5;

// One fault while it lasted. Times are those of the data.
struct HeightFault {
    HeightFaultKind kind = HeightFaultKind::Silence;
    Timestamp begin {};
    Timestamp end {};          // When it was last seen so.
    std::int32_t counts = 0;   // The reading, for a jump the one after it; 0 for silence.
    double speed_mm_per_s = 0; // Speed of a jump, the greatest …
    double step_mm = 0; // … and by how much the height stepped aside, up or down; 0: not told yet.
                        // Of a stop: by how much higher it lies now.
};

// Total of all faults of one kind.
struct HeightFaultTotal {
    std::size_t count = 0;
    Duration duration {}; // Sum of their durations.
    HeightFault worst {}; // The longest, of jumps the fastest.
};

// Where to draw the line between a hand's work and a fault.
struct HeightMonitorLimits {
    // A reading within this share of full scale of an end of the range, for this long.
    double rail_margin = 0.001; // At least the end itself.
    Duration rail_after = std::chrono::milliseconds(20);

    // A step that slips too slowly to be doubted at once, within some 30 ms, leaves the movement
    // before and after it as it was: of equal speed within this much, and aside by this much and by
    // so many times what the readings scatter. (A hand that begins or ends a movement changes the
    // speed.)
    double step_mm = 3;
    double step_scatters = 6;
    double step_speed_mm_per_s = 60;

    // Time without any reading.
    Duration silence_after = std::chrono::milliseconds(250);

    // Time with exactly the same reading: of a sensor whose readings flicker at rest, and of one
    // whose readings never did, as those of 10 bits may not.
    Duration stuck_after = std::chrono::seconds(5);
    Duration stuck_without_noise_after = std::chrono::seconds(60);
};

// Watches the height sensor's readings and tells what is wrong with it. Samples come in time order.
// By the data's times alone, so a log gives the faults that the live sensor gave. A fault is
// noticed as soon as it has lasted for its limit, and has begun when it did.
class HeightMonitor {
public:
    // The rig's model says how many millimetres a count is; where it does not hold, nothing is
    // called a jump.
    explicit HeightMonitor(Rig const& rig, HeightMonitorLimits const& limits = {});

    void push(drivers::HeightSample const& sample);

    // Whether a reading lies at an end of its range, where it tells no height.
    bool is_on_rail(drivers::HeightSample const& sample) const;

    // The sensor went away: what it reads when it is back has nothing to do with what it read.
    void begin_anew();

    // Whether the last reading was one that the surface cannot have, as things are.
    bool doubts_last() const { return doubts_last_; }

    // Other data show that it is `now`: without it, silence after the last reading goes unnoticed.
    // The first call, or the first reading, begins the watch.
    void advance(Timestamp now);

    // Returns what is wrong at this moment; the first of HeightFaultKind's order if several things
    // are. A jump counts as present for half a second, a stop that has moved for ten.
    std::optional<HeightFault> present() const;

    // Returns the total of everything so far, what is present included.
    HeightFaultTotal total(HeightFaultKind kind) const;

    // Readings per second, over the last second of readings; 0 until there are two.
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
    void watch_step(drivers::HeightSample const& sample);
    void watch_stop(drivers::HeightSample const& sample);
    void watch_stuck(drivers::HeightSample const& sample);
    void learn_noise(drivers::HeightSample const& sample);
    void watch_rate(Timestamp time);

    Rig rig_;
    HeightMonitorLimits limits_;
    std::array<Watch, kHeightFaultKinds> watches_ {};

    HeightJudge judge_ {};
    std::vector<HeightJudge::Reading> believed_ {}; // Kept for its memory.
    bool doubts_last_ = false;
    std::size_t doubts_ = 0;                // Readings since the last believed one …
    std::optional<HeightFault> doubted_ {}; // … and what they are if they are wrong.

    std::optional<Timestamp> alive_ {};            // The last reading, or when the watch began.
    std::optional<drivers::HeightSample> last_ {}; // The last reading.
    std::optional<Timestamp> rail_since_ {};       // Set as long as readings are there.
    Timestamp same_since_ {};                      // Since when all readings are like the last.

    // Heights of the last 0.1 s, to find steps.
    struct Height {
        Timestamp time {};
        double mm = 0;
    };
    std::deque<Height> path_ {};

    LowestStop stop_ {};

    // Noise: a change of the reading and the opposite change soon after it, which no hand does.
    Timestamp last_change_ {};
    int last_change_sign_ = 0;
    std::size_t flickers_ = 0;

    std::deque<Timestamp> recent_ {}; // Readings of the last second.
};

// Returns all that was wrong, a sentence each, for the user: what it was, how often and how long,
// and what to look at. Empty if nothing was. Times in them count from `start`.
std::vector<std::string> describe_faults(HeightMonitor const& monitor, Timestamp start);

// Returns what is wrong now, in a few words for a line of the screen, which need not be drawn anew
// more than once a second: "height sensor silent for 3 s: is it plugged in?"
std::string describe_fault(HeightFault const& fault);

} // namespace tractus::calib
