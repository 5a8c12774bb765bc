#pragma once

#include "calib/height_track.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/time.h"

#include <deque>
#include <optional>
#include <vector>

namespace tractus::calib {

// A pen that touches and is silent while the surface moves.
//
// Many tablets report only changes: a pen held still is silent, although the surface moves it up or
// down. The height sensor is then the only clock, and its readings determine when the pen has
// further tips, at its last reported position and pressure.
//
// A pen counts as silent when nothing has arrived for two and a half of its own periods or, if its
// reports come in bundles, for one and a half times the interval between bundles; a tablet that
// reports continuously is never silent. The surface counts as moving when it is kMoved_mm away from
// its height at the last tip. The tips then begin where the silence did, or kLookBack ago if that
// is later. They are at least kMinSpacing and, if there are enough readings, at most kMaxSpacing
// apart, until the surface has stood still for kLookBack.
//
// A silence may also mean that reports were lost. The next report shows whether the pen rested: it
// is then still at its position. Until then tips are in doubt, for at most kDoubt or, if the
// silence may mean that the pen has left, until the next report.
//
// No clock is read: equal samples and readings give equal tips.
class SilentTouch {
public:
    static constexpr double kMoved_mm = 0.5; // The surface counts as moving beyond this.
    // A pen that rested moves no farther than this until its next report.
    static constexpr double kRested_mm = 2;
    static constexpr Duration kMinSpacing = std::chrono::milliseconds(3);
    static constexpr Duration kMaxSpacing = std::chrono::milliseconds(10);
    static constexpr Duration kLookBack = std::chrono::milliseconds(120);
    static constexpr Duration kDoubt = std::chrono::milliseconds(150);

    // Meaning of a silence, decided by the report that ends it.
    enum class Silence {
        Rest, // The pen is where it was.
        Loss, // The pen is elsewhere: reports were lost.
    };

    // `latency` is the delay from the pen being at a position to the arrival of the report.
    explicit SilentTouch(Duration latency)
        : latency_(latency)
    {
    }

    // Adds the pen's next sample and its arrival; the sample's own time may be evened. A sample
    // that does not touch ends the touch.
    Silence hear(drivers::PenSample const& pen, Timestamp arrival);

    // Ends the touch as of the beginning of the silence.
    void forget() { pen_.reset(); }

    // Adds the instant of a reading, with the latency subtracted.
    void read(Timestamp instant);

    // The pen's last sample; valid only while it touches.
    drivers::PenSample const& pen() const { return *pen_; }

    // Returns the instants at which tips are now known to be needed, each once, in time order.
    // `now` is the arrival of the last reading: what the pen did within its latency before that may
    // still be reported. `heights` contains the readings.
    std::vector<Timestamp> take_instants(Timestamp now, HeightTrack const& heights,
                                         Duration max_height_age);

    // True if the pen has been silent for so long that it certainly rests.
    bool is_surely_resting(Timestamp now) const { return pen_ && now - arrival_ > kDoubt; }

private:
    static constexpr Duration kSilenceOfNewPen = std::chrono::milliseconds(40);

    void learn_interval(Duration interval);

    Duration latency_;
    std::optional<drivers::PenSample> pen_; // Last sample; no value while the pen does not touch.
    Timestamp arrival_ {};                  // Arrival of the last sample, touching or not.
    bool has_arrived_ = false;
    std::deque<Duration> intervals_;    // The latest intervals between samples.
    Duration period_ = Duration::max(); // The shortest usual interval so far.
    Duration silent_after_ = kSilenceOfNewPen;

    // Instants since the last sample that have not been examined yet.
    std::deque<Timestamp> to_come_;
    std::deque<Timestamp> passed_over_;    // Instants examined while the surface stood still.
    Timestamp last_instant_ {};            // Instant of the last sample, or of a later reading.
    std::optional<double> last_height_mm_; // Height of the surface at the last tip.
    std::optional<Timestamp> moves_until_;
};

} // namespace tractus::calib
