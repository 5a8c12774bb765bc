#pragma once

#include "calib/even_times.h"
#include "calib/height_judge.h"
#include "calib/height_scenario.h"
#include "calib/height_track.h"
#include "calib/lean_track.h"
#include "calib/rig.h"
#include "calib/silent_touch.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/pen_sample.h"
#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::calib {

// Replaces the height sensor for logs without one.
struct ScriptedHeight {
    HeightScenario scenario;
    Timestamp first_pen {}; // PenSample::time of the log's first pen sample.
    Timestamp last_pen {};  // PenSample::time of the log's last pen sample.
};

// Statistics of a fuser, for reports and for explaining why there are no strokes.
struct FuserCounts {
    // Number of pen samples pushed. `settled` counts those that became a settled tip,
    // `pens_without_height` those given up because no reading lay within Rig::max_height_age.
    std::size_t pens = 0;
    std::size_t settled = 0;
    std::size_t pens_without_height = 0;

    // Number of height samples pushed. `heights_refused` counts those of another converter or
    // outside the model, `heights_doubted` those doubted on arrival (height_judge.h), regardless of
    // the later decision, and `heights_uncalibrated` those used although outside the calibrated
    // range.
    std::size_t heights = 0;
    std::size_t heights_refused = 0;
    std::size_t heights_doubted = 0;
    std::size_t heights_uncalibrated = 0;

    // Number of tips settled from readings while a touching pen was silent. Not included in
    // `settled`.
    std::size_t settled_in_silence = 0;

    // Number of settled tips outside the calibrated range, including those settled in a silence.
    std::size_t settled_uncalibrated = 0;
};

// Combines the two sensors: a pen on the tablet, and the height of the tablet's carriage.
//
// Each pen sample gives two tips, and so does each height reading while a touching pen is silent
// and the surface moves (silent_touch.h). The live tip comes at once, for drawing; its height is
// usually extrapolated from the last readings (HeightTrack::newest_at()). The settled tip is final.
// It comes when the readings around its instant have arrived, with a height from a line fitted
// through them (height_track.h). The instant of a sample is its time minus the latency of its
// sensor; if the rig asks for evened times, EvenTimes estimates them from the arrivals. If the rig
// has a coil height, the displacement by the pen's lean is subtracted (lean_track.h); for settled
// tips, later leans are used too. The rig's PressureResponse decides whether a tip touches, and how
// strongly.
//
// Accuracy, with 12-bit heights 500 times a second, one count of noise, and a hand moving at 300
// mm/s in the plane and 200 mm/s in height: tips are off by 0.1 mm on average; settled ones by at
// most 0.5 mm, live ones by at most 1 mm.
//
// A tip more than kCalibrationMargin_mm outside the rig's calibrated range is marked, since its
// height is extrapolated. (Within the margin it may be noise at an end of the travel.)
//
// Samples of one sensor should arrive in time order; a late height is inserted in its place if it
// can still affect unsettled tips. The two sensors may interleave in any way, as long as neither is
// ahead of the other by more than kPatience. Not thread-safe: used on the main thread. It uses
// neither clock nor random numbers, so equal samples give equal tips.
class Fuser {
public:
    static constexpr Duration kPatience = std::chrono::seconds(1);
    static constexpr double kCalibrationMargin_mm = 1;

    explicit Fuser(Rig const& rig);

    // For a log without a height sensor: heights come from the scenario, every tip is final at
    // once, and height samples are ignored.
    Fuser(Rig const& rig, ScriptedHeight const& height);

    // Adds a height sample. Readings that are implausible for a moving surface are ignored, also
    // for live tips (see HeightJudge). The height is interpolated across a few such readings.
    void push(drivers::HeightSample const& sample);

    // Notes that the sensor gave a reading without a usable height.
    void miss_height(Timestamp received);

    // Adds a pen sample and returns its live tip. No value before the first height, or while the
    // last height is older than Rig::max_height_age. The first tip after such a gap does not touch,
    // so that no stroke crosses the gap.
    //
    // A pen that is out of range also gives tips. They are lifted, at its last position in range.
    [[nodiscard]] std::optional<TipSample> push(drivers::PenSample const& pen);

    // Returns the live tips made from readings since the last call while the pen was silent, in
    // time order. They all touch.
    [[nodiscard]] std::vector<TipSample> take_live() { return std::exchange(live_in_silence_, {}); }

    // Sets whether the pen may leave without reporting it, so that a silence may mean that it has
    // left. Tips in a silence then settle only with the next pen sample. Initially false.
    void set_may_leave_silently(bool may) { may_leave_silently_ = may; }

    // Discards the tips since the pen fell silent, because it is known to have left then.
    void forget_silence();

    // Returns the tips that have settled since the last call, in the order of their instants. They
    // are marked as interpolated unless readings exist on one side only (before the first reading,
    // or after the sensor was lost: the movement is extrapolated for 5 ms and then held). A pen
    // sample without a reading nearby is left out, and the tip after it does not touch.
    [[nodiscard]] std::vector<TipSample> take_settled();

    // Settles all remaining tips from the available readings, at the end of the samples or before a
    // pause. If the pen last touched, it is assumed to have touched until now.
    void flush();

    // Forgets all heights when the sensor was disconnected, after flush(): its later readings are
    // unrelated to earlier ones.
    void forget_heights();

    FuserCounts const& counts() const { return counts_; }

private:
    // The pen at an instant: at a sample, or in a silence after one, at that sample's position.
    struct Moment {
        drivers::PenSample pen;
        Timestamp instant {};
        bool is_in_silence = false;
        bool is_in_doubt = false; // True if the silence may turn out to be a loss of reports.
    };

    bool has_times_evened() const { return rig_.sample_times == SampleTimes::Evened && !scripted_; }
    drivers::PenSample apply_pressure_response(drivers::PenSample pen);
    TipSample tip(Moment const& moment, HeightTrack::Estimate const& height) const;
    Timestamp instant(drivers::PenSample const& pen) const
    {
        return pen.time - rig_.tablet_latency;
    }
    std::optional<HeightTrack::Estimate> height_at(Moment const& moment) const;
    std::optional<HeightTrack::Estimate> live_height_at(Moment const& moment) const;
    bool is_calibrated(double height_mm) const;
    bool has_all_readings(Timestamp instant) const;
    void believe(HeightJudge::Reading const& reading);
    void doubt(Timestamp instant);
    void follow_surface(Timestamp arrival);
    void keep_silence();
    void drop_silence();
    void drop_pending_silence(Timestamp from);
    void settle_ready();
    void settle_next();

    Rig rig_;
    Eigen::Affine3d T_world_tablet_;
    std::optional<HeightRange> calibrated_;
    std::optional<ScriptedHeight> scripted_;
    HeightJudge judge_;
    // Readings that the judge has just accepted. A member only to reuse its memory.
    std::vector<HeightJudge::Reading> believed_;
    HeightTrack heights_;
    LeanTrack leans_; // Recent leans of the pen; empty if the rig has no coil height.
    EvenTimes pen_times_;
    EvenTimes height_times_;
    SilentTouch touch_;
    std::deque<Moment> pending_; // Moments that are not settled yet, in time order.
    std::vector<TipSample> settled_;
    // Settled tips of the present silence, dropped if the silence was a loss of reports.
    std::vector<TipSample> doubtful_;
    std::vector<TipSample> live_in_silence_;
    Timestamp last_live_in_silence_ = Timestamp::min();
    Timestamp last_settled_in_silence_ = Timestamp::min();
    // True once the pen certainly rests, so that later tips in the silence are not in doubt.
    bool is_silence_sure_ = false;
    bool may_leave_silently_ = false;
    bool presses_ = false; // True while the pressure is above the rig's threshold.
    bool gap_before_live_ = false;
    bool gap_before_settled_ = false;
    FuserCounts counts_;
};

} // namespace tractus::calib
