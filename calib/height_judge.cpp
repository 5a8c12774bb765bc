#include "calib/height_judge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tractus::calib {

namespace {

// Deviations from the expected height up to this are noise, which the track's fit smooths.
constexpr double kMinDoubted_mm = 0.5;
constexpr double kNoiseCounts = 4; // Height steps of up to this many counts are noise.
// Deviations up to this multiple of the median second difference are noise.
constexpr double kNoises = 4;
constexpr std::size_t kRemembered = 64;
constexpr std::size_t kFewRemembered = 15; // With fewer readings, neither rate nor noise is known.
// Longer intervals between readings are pauses, which do not count towards the sensor's rate.
constexpr double kPause_s = 0.1;
constexpr double kTrack_s = 0.02; // Time over which the speed is measured; see kTrackReadings.
// The speed is measured over this number of readings if they take longer.
constexpr std::size_t kTrackReadings = 4;
constexpr std::size_t kMaxReadings = 64;
// Ratio of the median to the lower quartile of a normal distribution's absolute values.
constexpr double kMedianPerQuartile = 2.117;
constexpr double kUnseenOfNew_s = 0.01;

template<typename Values> void keep_last(Values& values, std::size_t count)
{
    if (values.size() > count)
        values.pop_front();
}

} // namespace

// Learns the rate of the readings, and their noise. The noise comes from second differences, which
// are zero in a steady movement. Each wrong reading spoils three second differences, so the median
// of the others is estimated from the lower quartile.
void HeightJudge::learn(Reading const& reading)
{
    bool const is_first = last_arrival_ == Timestamp::min();
    interval_s_ = is_first ? 0 : to_seconds(reading.arrival - last_arrival_);
    last_arrival_ = reading.arrival;
    if (!is_first && interval_s_ <= kPause_s) {
        intervals_s_.push_back(interval_s_);
        keep_last(intervals_s_, kRemembered);
        usual_interval_s_ = std::accumulate(intervals_s_.begin(), intervals_s_.end(), 0.0)
            / static_cast<double>(intervals_s_.size());
        auto sorted = std::vector(intervals_s_.begin(), intervals_s_.end());
        std::sort(sorted.begin(), sorted.end());
        longest_interval_s_ = sorted[sorted.size() - std::min<std::size_t>(sorted.size(), 2)];
    }
    if (heights_mm_.size() == 2) {
        bends_mm_.push_back(std::abs(reading.height_mm - 2 * heights_mm_[1] + heights_mm_[0]));
        keep_last(bends_mm_, kRemembered);
        auto sorted = std::vector(bends_mm_.begin(), bends_mm_.end());
        auto const quarter = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 4);
        std::nth_element(sorted.begin(), quarter, sorted.end());
        usual_bend_mm_ = is_new() ? kInitialBend_mm : kMedianPerQuartile * *quarter;
    }
    heights_mm_.push_back(reading.height_mm);
    keep_last(heights_mm_, 2);
}

// Fits a line to the last readings by least squares. If they are too few or too close together, the
// result has only the height of the last reading.
HeightJudge::Line HeightJudge::line_through(Readings const& track) const
{
    Line line { .height_mm = track.back().height_mm };
    double times = 0;
    double heights = 0;
    double count = 0;
    auto first = track.rbegin();
    for (; first != track.rend(); ++first) {
        double const seconds = to_seconds(first->arrival - track.back().arrival);
        if (count >= kTrackReadings && -seconds > kTrack_s)
            break;
        line.span_s = -seconds;
        times += seconds;
        heights += first->height_mm;
        ++count;
    }
    double squares = 0;
    double products = 0;
    for (auto reading = track.rbegin(); reading != first; ++reading) {
        double const off_s = to_seconds(reading->arrival - track.back().arrival) - times / count;
        squares += off_s * off_s;
        products += off_s * (reading->height_mm - heights / count);
    }
    line.is_known
        = count >= kTrackReadings && squares > count * usual_interval_s_ * usual_interval_s_ / 4;
    if (!line.is_known)
        return line;
    line.mm_per_s = std::clamp(products / squares, -kFastest_mm_per_s, kFastest_mm_per_s);
    line.height_mm = heights / count - line.mm_per_s * times / count;
    return line;
}

bool HeightJudge::is_new() const
{
    return bends_mm_.size() < kFewRemembered;
}

// Returns the length of time in which the surface may have changed its movement unobserved. It is
// at least the longest interval between readings, because bundled deliveries do not show when
// readings were taken.
double HeightJudge::unseen_s() const
{
    return std::max({ interval_s_, longest_interval_s_, is_new() ? kUnseenOfNew_s : 0 });
}

double HeightJudge::noise_mm() const
{
    return std::max(kMinDoubted_mm, kNoiseCounts * count_mm_) + kNoises * usual_bend_mm_;
}

// Returns the height error that sampling jitter can cause at this speed: readings are not taken at
// exactly the times assumed.
double HeightJudge::jitter_mm(double mm_per_s) const
{
    double const jitter_s = longest_interval_s_ - usual_interval_s_;
    bool const is_bundled = jitter_s > usual_interval_s_ / 2;
    double mm = std::abs(mm_per_s) * (is_bundled ? 1.5 * longest_interval_s_ : jitter_s);
    if (interval_s_ < usual_interval_s_ / 2)
        mm += kFastest_mm_per_s * usual_interval_s_;
    return mm;
}

// True if the reading continues the movement of the last believed readings. The tolerance grows
// only with time without readings, not with doubted readings. It includes an acceleration since the
// middle of the fitted line, which the line's speed does not show.
bool HeightJudge::goes_on(Reading const& reading) const
{
    auto const line = line_through(track_);
    double const since_s = to_seconds(reading.arrival - track_.back().arrival);
    double const expected_mm = line.height_mm + line.mm_per_s * std::min(since_s, kPause_s);
    double const unseen_s = this->unseen_s();
    double const square_s
        = line.span_s * line.span_s / 6 + line.span_s * unseen_s + unseen_s * unseen_s;
    double slack_mm
        = noise_mm() + jitter_mm(line.mm_per_s) + kMaxAcceleration_mm_per_ss / 2 * square_s;
    if (!line.is_known || is_new())
        slack_mm += kFastest_mm_per_s * unseen_s;
    return std::abs(reading.height_mm - expected_mm) <= slack_mm;
}

bool HeightJudge::continues_run(Reading const& reading) const
{
    constexpr double kFastRun_mm_per_s = 600;
    double const unseen_s = this->unseen_s();
    auto const& last = run_.back();
    double const step_mm = reading.height_mm - last.height_mm;
    if (run_.size() < 2)
        return std::abs(step_mm) <= noise_mm() + kFastRun_mm_per_s * unseen_s + jitter_mm(0);
    double const bend_mm = step_mm - (last.height_mm - run_[run_.size() - 2].height_mm);
    auto const line = line_through(run_);
    return std::abs(bend_mm) <= 2 * noise_mm() + 2 * jitter_mm(line.mm_per_s)
        + kMaxAcceleration_mm_per_ss * unseen_s * unseen_s;
}

// True if the run of doubted readings joins on to the last believed ones. Under a steady
// acceleration in between, the lines through both meet halfway; an abrupt turn may lie anywhere
// between two readings.
bool HeightJudge::run_leads_back() const
{
    constexpr double kUnsteady_mm_per_ss = 1000;
    auto const before = line_through(track_);
    if (!before.is_known)
        return true; // With so few readings, any may be the wrong one.
    auto const after = line_through(run_);
    double const since_s = to_seconds(run_.back().arrival - track_.back().arrival);
    double const gap_s = to_seconds(run_.front().arrival - track_.back().arrival);
    double const forth_mm = before.height_mm + before.mm_per_s * gap_s / 2;
    double const back_mm = after.height_mm - after.mm_per_s * (since_s - gap_s / 2);
    double const corner_mm = std::abs(after.mm_per_s - before.mm_per_s) * unseen_s() / 2;
    double const slack_mm = 2 * noise_mm() + corner_mm + kUnsteady_mm_per_ss / 2 * gap_s * gap_s
        + jitter_mm(std::max(std::abs(before.mm_per_s), std::abs(after.mm_per_s)));
    return std::abs(back_mm - forth_mm) <= slack_mm;
}

void HeightJudge::believe(Reading const& reading)
{
    track_.push_back(reading);
    keep_last(track_, kMaxReadings);
}

void HeightJudge::accept_run(std::vector<Reading>& believed)
{
    track_.clear();
    for (auto const& reading : run_)
        believe(reading);
    believed.insert(believed.end(), run_.begin(), run_.end());
    run_.clear();
    doubted_in_a_row_ = 0;
}

HeightJudge::Verdict HeightJudge::judge(Reading const& reading, double count_mm,
                                        std::vector<Reading>& believed)
{
    // A late reading cannot be judged, since its neighbours have already been judged.
    if (reading.arrival < last_arrival_) {
        believed.push_back(reading);
        return Verdict::Believed;
    }
    count_mm_ = count_mm;
    learn(reading);
    if (track_.empty() || goes_on(reading)) {
        run_.clear();
        doubted_in_a_row_ = 0;
        believe(reading);
        believed.push_back(reading);
        return Verdict::Believed;
    }
    if (!run_.empty() && !continues_run(reading))
        run_.clear();
    run_.push_back(reading);
    ++doubted_in_a_row_;
    if (run_.size() >= kFewInRun && run_leads_back()) {
        accept_run(believed);
        return Verdict::Believed;
    }
    if (run_.size() > kMaxWrong && reading.arrival - run_.front().arrival >= kMinStep) {
        accept_run(believed);
        return Verdict::Step;
    }
    return Verdict::Doubted;
}

void HeightJudge::miss()
{
    run_.clear();
    ++doubted_in_a_row_;
}

} // namespace tractus::calib
