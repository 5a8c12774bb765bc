#pragma once

#include "calib/height_track.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/time.h"

#include <deque>
#include <optional>
#include <vector>

namespace tractus::calib {

// A pen that touches and says nothing while the surface moves.
//
// Many tablets report only what changes: a pen pressed still is silent, although the surface
// carries it up or down. Then the height sensor is the only clock, and its readings say when the
// pen has further tips, at the place and with the pressure that it reported last.
//
// A pen counts as silent once nothing has come for two and a half of its own periods, or, where its
// reports come in bundles, for half as long again as between these: a tablet that sends all the
// time never is. The surface counts as moving once it is kMoved_mm from where it was at the last
// tip; the tips then begin where the silence did, or kLookBack ago if that is later. They are at
// least kMinSpacing and, where readings allow it, at most kMaxSpacing apart, until the surface has
// stood still for kLookBack.
//
// A silence may also mean that reports were lost. Whether the pen really rested shows in the next
// report: a pen that rested is still where it was. Until then tips are in doubt, at most for
// kDoubt, and where a silence may mean that the pen has left, until the next report.
//
// It reads no clock: the same samples and readings give the same tips.
class SilentTouch {
public:
    static constexpr double kMoved_mm = 0.5;
    static constexpr double kRested_mm
        = 2; // A pen that rested begins to move no farther than that.
    static constexpr Duration kMinSpacing = std::chrono::milliseconds(3);
    static constexpr Duration kMaxSpacing = std::chrono::milliseconds(10);
    static constexpr Duration kLookBack = std::chrono::milliseconds(120);
    static constexpr Duration kDoubt = std::chrono::milliseconds(150);

    // What a report says about the silence before it.
    enum class Silence {
        Rest, // The pen is where it was.
        Loss, // It is elsewhere: reports were lost.
    };

    // `latency`: from the pen's being there to its report's arrival.
    explicit SilentTouch(Duration latency)
        : latency_(latency)
    {
    }

    // The pen's next sample and when it arrived; the time in the sample may be evened. Samples in
    // which the pen does not touch end the touch.
    Silence hear(drivers::PenSample const& pen, Timestamp arrival);

    // The touch was over when the silence began.
    void forget() { pen_.reset(); }

    // The instant of another reading, its latency taken off.
    void read(Timestamp instant);

    // The pen's last sample; only while it touches.
    drivers::PenSample const& pen() const { return *pen_; }

    // The instants of tips that are known by now to be needed, each given once, in time order.
    // `now` is when the last reading arrived: what the pen did later than its latency ago may still
    // be reported. `heights` has the readings.
    std::vector<Timestamp> take_instants(Timestamp now, HeightTrack const& heights,
                                         Duration max_height_age);

    // Whether the pen has been silent for so long that it rests, whatever comes next.
    bool is_surely_resting(Timestamp now) const { return pen_ && now - arrival_ > kDoubt; }

private:
    static constexpr Duration kSilenceOfNewPen = std::chrono::milliseconds(40);

    void learn_interval(Duration interval);

    Duration latency_;
    std::optional<drivers::PenSample> pen_; // While it touches.
    Timestamp arrival_ {};                  // Of the last sample, touching or not.
    bool has_arrived_ = false;
    std::deque<Duration> intervals_;    // The last ones between samples.
    Duration period_ = Duration::max(); // The shortest usual interval so far.
    Duration silent_after_ = kSilenceOfNewPen;

    std::deque<Timestamp> to_come_;        // Instants since the last sample, not looked at yet.
    std::deque<Timestamp> passed_over_;    // Looked at while the surface stood still.
    Timestamp last_instant_ {};            // The last sample's, or of the reading after it.
    std::optional<double> last_height_mm_; // The surface at the last tip.
    std::optional<Timestamp> moves_until_;
};

} // namespace tractus::calib
