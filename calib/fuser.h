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

// Stands in for the height sensor where a log has none.
struct ScriptedHeight {
    HeightScenario scenario;
    Timestamp first_pen {}; // PenSample::time of the log's first pen sample …
    Timestamp last_pen {};  // … and of its last.
};

// Counts of what a fuser has seen, for reports and for telling why there are no strokes.
struct FuserCounts {
    // Pen samples pushed; of them, settled to a tip; of them, given up because no reading lay
    // within Rig::max_height_age.
    std::size_t pens = 0;
    std::size_t settled = 0;
    std::size_t pens_without_height = 0;

    // Height samples pushed; of them, refused because they are another converter's or out of the
    // model's reach; of them, doubted when they came (height_judge.h), whatever became of it; of
    // them, used although outside the calibrated range.
    std::size_t heights = 0;
    std::size_t heights_refused = 0;
    std::size_t heights_doubted = 0;
    std::size_t heights_uncalibrated = 0;

    // Settled tips of readings, while a pen that touched was silent. Not among `settled`.
    std::size_t settled_in_silence = 0;

    // How many of the settled tips, of both kinds, are outside the calibrated range.
    std::size_t settled_uncalibrated = 0;
};

// Joins the two sensors: a pen on the tablet and the height of the tablet's carriage.
//
// Each pen sample gives two tips, and so does each reading of the height while a pen that touches
// is silent and the surface moves (silent_touch.h). One comes at once, for live ink; its height is
// mostly carried on from the last readings (HeightTrack::newest_at). The other comes later and is
// final: settled, once the readings around its instant have come, from a line fitted through them
// (height_track.h). The instants are those of the samples less their sensor's latency; where the
// rig has times evened, of the samples as EvenTimes tells them from their arrivals. Where the rig
// knows how far up the pen the tablet sees it, the pen's lean is taken off its place
// (lean_track.h), of settled tips with the leans after them known, too. Whether a tip touches, and
// how strongly, is as the rig's PressureResponse has it.
//
// Tips lie 0.1 mm from the truth in the mean, with heights 500 times a second of 12 bits and one
// count of noise, and a hand at 300 mm/s in the plane and 200 mm/s in height; settled ones at most
// 0.5 mm, live ones at most 1 mm.
//
// A tip more than kCalibrationMargin_mm above or below the rig's calibrated range is marked as
// such: its height is a guess. (Within the margin it may be noise at either end of the travel.)
//
// Samples of one sensor should come in time order; a height that comes late is put in its place as
// far as tips are not settled yet. The two sensors may interleave in any way, as long as neither
// runs ahead of the other by more than kPatience. Not thread-safe: it lives on the main thread. No
// clock and no randomness, so the same samples always give the same tips.
class Fuser {
public:
    static constexpr Duration kPatience = std::chrono::seconds(1);
    static constexpr double kCalibrationMargin_mm = 1;

    explicit Fuser(Rig const& rig);

    // Serves a log without a height sensor: heights are the scenario's, every tip is final at once,
    // and height samples are ignored.
    Fuser(Rig const& rig, ScriptedHeight const& height);

    // Readings that the surface cannot have are left out, also of live ink: see HeightJudge. Where
    // they are few, the height goes on across them.
    void push(drivers::HeightSample const& sample);

    // The sensor gave a reading that tells no height.
    void miss_height(Timestamp received);

    // The live tip. No value until the first height has come, and while the last one is older than
    // Rig::max_height_age. After such a gap the first tip is given as not touching, so that no
    // stroke leads across it.
    //
    // Every pen sample has its tip, those out of range too: they say that the pen is up, at the
    // last position in range.
    [[nodiscard]] std::optional<TipSample> push(drivers::PenSample const& pen);

    // Live tips that came of readings since the last call, while the pen was silent, in time order.
    // They touch.
    [[nodiscard]] std::vector<TipSample> take_live() { return std::exchange(live_in_silence_, {}); }

    // Whether the pen may leave without a word, so that a silence may mean that it has left. Tips
    // in a silence then settle only with the next pen sample. At first it says so itself.
    void set_may_leave_silently(bool may) { may_leave_silently_ = may; }

    // The pen is known to have left when it fell silent: forgets the tips since.
    void forget_silence();

    // The tips that have settled since the last call, in the order of their instants. They are
    // marked as interpolated, save where readings lay on one side alone (before the first, or once
    // the sensor is lost: the movement is carried on for 5 ms, and its end held from there). A pen
    // sample without a reading near it is left out, and the tip after it does not touch.
    [[nodiscard]] std::vector<TipSample> take_settled();

    // No more samples come, or none for a while: settles what is left from the readings at hand. A
    // pen that touches is taken to have done so until now.
    void flush();

    // The height sensor went away, after flush(): what it reads when it is back has nothing to do
    // with what it read.
    void forget_heights();

    FuserCounts const& counts() const { return counts_; }

private:
    // The pen at an instant: where a sample had it, or, while it was silent, where the sample
    // before had it.
    struct Moment {
        drivers::PenSample pen;
        Timestamp instant {};
        bool is_in_silence = false;
        bool is_in_doubt = false; // The silence may turn out as a loss of reports.
    };

    bool has_times_evened() const { return rig_.sample_times == SampleTimes::Evened && !scripted_; }
    drivers::PenSample as_felt(drivers::PenSample pen);
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
    std::vector<HeightJudge::Reading> believed_; // Kept for its memory.
    HeightTrack heights_;
    LeanTrack leans_; // Empty where the rig does not need it.
    EvenTimes pen_times_;
    EvenTimes height_times_;
    SilentTouch touch_;
    std::deque<Moment> pending_; // Not settled yet, in time order.
    std::vector<TipSample> settled_;
    std::vector<TipSample> doubtful_; // Settled, of moments in doubt.
    std::vector<TipSample> live_in_silence_;
    Timestamp last_live_in_silence_ = Timestamp::min();
    Timestamp last_settled_in_silence_ = Timestamp::min();
    bool is_silence_sure_ = false; // The pen rests: further tips in the silence are in no doubt.
    bool may_leave_silently_ = false;
    bool presses_ = false; // Above the rig's pressure threshold.
    bool gap_before_live_ = false;
    bool gap_before_settled_ = false;
    FuserCounts counts_;
};

} // namespace tractus::calib
