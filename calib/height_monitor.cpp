#include "calib/height_monitor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tractus::calib {

namespace {

// Jumps within this time of each other count as one, such as a jump and its return.
constexpr Duration kJumpLasts = std::chrono::milliseconds(500);
// Time for which a slip or a moved stop is reported, long enough for the message to be read.
constexpr Duration kSlipIsTold = std::chrono::seconds(10);

// If a reading changes and changes back within this time, that is noise. A sensor with at least
// kNoisyFlickers such changes has noise.
constexpr Duration kFlicker = std::chrono::milliseconds(100);
constexpr std::size_t kNoisyFlickers = 5;

bool is_worse(HeightFault const& a, HeightFault const& b)
{
    if (a.kind != HeightFaultKind::Jump && a.kind != HeightFaultKind::Stop)
        return a.end - a.begin > b.end - b.begin;
    return a.speed_mm_per_s != b.speed_mm_per_s ? a.speed_mm_per_s > b.speed_mm_per_s
                                                : std::abs(a.step_mm) > std::abs(b.step_mm);
}

void add(HeightFaultTotal& total, HeightFault const& fault)
{
    if (total.count++ == 0 || is_worse(fault, total.worst))
        total.worst = fault;
    total.duration += fault.end - fault.begin;
}

} // namespace

HeightMonitor::HeightMonitor(Rig const& rig, HeightMonitorLimits const& limits)
    : rig_(rig)
    , limits_(limits)
{
}

void HeightMonitor::push(drivers::HeightSample const& sample)
{
    advance(sample.time);
    close(HeightFaultKind::Silence);
    alive_ = std::max(alive_.value_or(sample.time), sample.time);
    watch_rail(sample);
    watch_jump(sample);
    thin_batches(sample);
    watch_step(sample);
    watch_slow_slip(sample);
    watch_stop(sample);
    watch_stuck(sample);
    watch_rate(sample.time);
    last_ = sample;
}

void HeightMonitor::advance(Timestamp now)
{
    auto const& jump = watch(HeightFaultKind::Jump).open;
    bool const is_slip = jump && jump->step_mm != 0;
    close_old(HeightFaultKind::Jump, is_slip ? kSlipIsTold : kJumpLasts, now);
    close_old(HeightFaultKind::Stop, kSlipIsTold, now);
    if (!alive_)
        alive_ = now;
    if (now - *alive_ > limits_.silence_after)
        see({ .kind = HeightFaultKind::Silence, .begin = *alive_, .end = now });
}

// Begins a fault of this kind, or extends it if it is already present.
void HeightMonitor::see(HeightFault const& fault)
{
    auto& open = watch(fault.kind).open;
    if (!open) {
        open = fault;
        return;
    }
    open->end = std::max(open->end, fault.end);
    if (fault.speed_mm_per_s > open->speed_mm_per_s) {
        open->speed_mm_per_s = fault.speed_mm_per_s;
        open->counts = fault.counts;
    }
    if (std::abs(fault.step_mm) > std::abs(open->step_mm))
        open->step_mm = fault.step_mm;
}

void HeightMonitor::close(HeightFaultKind kind)
{
    auto& [open, closed] = watch(kind);
    if (open)
        add(closed, *open);
    open.reset();
}

void HeightMonitor::close_old(HeightFaultKind kind, Duration lasts, Timestamp now)
{
    auto const& open = watch(kind).open;
    if (open && now - open->end > lasts)
        close(kind);
}

void HeightMonitor::restart_after_reconnection()
{
    for (auto const kind : { HeightFaultKind::Rail, HeightFaultKind::Stuck })
        close(kind);
    judge_ = {};
    believed_.clear();
    doubts_last_ = false;
    doubts_ = 0;
    doubted_.reset();
    last_.reset();
    rail_since_.reset();
    path_.clear();
    slow_slip_.clear();
    batch_end_.reset();
    recent_.clear();
}

bool HeightMonitor::is_on_rail(drivers::HeightSample const& sample) const
{
    auto const margin = limits_.rail_margin * sample.full_scale;
    return sample.counts <= margin || sample.counts >= sample.full_scale - margin;
}

void HeightMonitor::watch_rail(drivers::HeightSample const& sample)
{
    if (!is_on_rail(sample)) {
        rail_since_.reset();
        close(HeightFaultKind::Rail);
        return;
    }
    if (!rail_since_)
        rail_since_ = sample.time;
    if (sample.time - *rail_since_ >= limits_.rail_after)
        see({ .kind = HeightFaultKind::Rail,
              .begin = *rail_since_,
              .end = sample.time,
              .counts = sample.counts });
}

std::optional<double> HeightMonitor::height_of(drivers::HeightSample const& sample) const
{
    if (sample.full_scale != rig_.full_scale_counts || is_on_rail(sample))
        return std::nullopt;
    return height_mm(rig_.height_model, sample.counts);
}

// Reports a jump when doubted readings have turned out to be wrong, or to be a step.
void HeightMonitor::watch_jump(drivers::HeightSample const& sample)
{
    auto const height = height_of(sample);
    doubts_last_ = false;
    believed_.clear();
    if (!height) {
        judge_.miss();
        return;
    }
    auto const count_mm = mm_per_count_at(rig_.height_model, sample.counts).value_or(0);
    auto const verdict
        = judge_.judge({ sample.time, sample.time, *height }, std::abs(count_mm), believed_);
    doubts_last_ = verdict == HeightJudge::Verdict::Doubted;
    if (doubts_last_)
        return doubt(sample, *height);
    bool const all_were_right
        = verdict == HeightJudge::Verdict::Believed && believed_.size() > doubts_;
    if (doubted_ && !all_were_right)
        see(*doubted_);
    if (verdict == HeightJudge::Verdict::Step) {
        // Otherwise the jump would be reported as a slow step and a slip as well.
        path_.clear();
        slow_slip_.clear();
        batch_end_.reset();
    }
    doubted_.reset();
    doubts_ = 0;
}

// Records a doubted reading. Doubted readings on the way to an end of the converter's range and
// back belong to the fault of that kind, not to a jump.
void HeightMonitor::doubt(drivers::HeightSample const& sample, double height_mm)
{
    // Intervals between arrivals shorter than this do not show when readings were taken, because
    // USB delivers in bursts.
    constexpr Duration kShortest = std::chrono::microseconds(2500);
    ++doubts_;
    auto const before = last_ ? height_of(*last_) : std::nullopt;
    if (!before)
        return;
    auto const duration = std::max(sample.time - last_->time, kShortest);
    double const speed_mm_per_s = std::abs(height_mm - *before) / to_seconds(duration);
    if (!doubted_)
        doubted_ = HeightFault { .kind = HeightFaultKind::Jump,
                                 .begin = sample.time,
                                 .end = sample.time,
                                 .counts = sample.counts };
    if (speed_mm_per_s > doubted_->speed_mm_per_s) {
        doubted_->speed_mm_per_s = speed_mm_per_s;
        doubted_->counts = sample.counts;
    }
}

namespace {

// A line fitted through heights on one side of a step.
struct Side {
    double seconds = 0; // Mean time of the heights, relative to the newest reading.
    double mm = 0;      // Height of the line at its mean time.
    double mm_per_s = 0;
    double scatter_mm = 0; // Standard deviation of the heights about the line.
    std::size_t count = 0;
};

template<typename Heights>
Side line_through(Heights const& heights, Timestamp newest, Duration from, Duration to)
{
    Side side;
    double squares = 0;
    double products = 0;
    double heights_squared = 0;
    for (auto const& height : heights) {
        auto const age = newest - height.time;
        if (age < from || age > to)
            continue;
        double const seconds = -to_seconds(age);
        double const n = static_cast<double>(++side.count);
        double const time_off = seconds - side.seconds;
        double const mm_off = height.mm - side.mm;
        side.seconds += time_off / n;
        side.mm += mm_off / n;
        squares += time_off * (seconds - side.seconds);
        products += time_off * (height.mm - side.mm);
        heights_squared += mm_off * (height.mm - side.mm);
    }
    if (squares > 0) {
        side.mm_per_s = products / squares;
        side.scatter_mm = std::sqrt(std::max(0.0, heights_squared - products * side.mm_per_s)
                                    / static_cast<double>(side.count));
    }
    return side;
}

constexpr Duration kSide = std::chrono::milliseconds(30);
constexpr Duration kStepTakes = std::chrono::milliseconds(30);

} // namespace

// Leaves only the last of the readings that arrive together, after a pause of the computer or in
// bursts: it is the one that was taken when it arrived. Each is known when the next batch begins.
void HeightMonitor::thin_batches(drivers::HeightSample const& sample)
{
    constexpr double kPartOfInterval = 0.5;
    thinned_.clear();
    if (!height_of(sample)) {
        slow_slip_.clear();
        batch_end_.reset();
    }
    double const hz = rate_hz();
    auto const lasts = Duration(hz > 0 ? std::llround(kPartOfInterval / hz * 1e9) : 0);
    for (auto const& reading : believed_) {
        bool const is_in_batch = batch_end_ && reading.arrival >= batch_begin_
            && reading.arrival - batch_begin_ < lasts;
        if (batch_end_ && !is_in_batch)
            thinned_.push_back(*batch_end_);
        if (!is_in_batch)
            batch_begin_ = reading.arrival;
        batch_end_ = reading;
    }
}

// Looks for a slow step: compares the heights of the last 30 ms with those of the 30 ms that ended
// 30 ms earlier. Without a step, the height between their middles changes by the mean of both
// speeds times the time, exactly so under a steady acceleration.
void HeightMonitor::watch_step(drivers::HeightSample const& sample)
{
    constexpr std::size_t kMinForStep = 3;
    if (!height_of(sample))
        path_.clear();
    // Readings that waited during a gap arrive together, so that their times are unknown.
    constexpr Duration kWaitingComes = std::chrono::milliseconds(5);
    for (auto const& reading : believed_) {
        bool const is_gap = !path_.empty()
            && (reading.arrival - path_.back().time > kStepTakes
                || reading.arrival < path_.back().time);
        if (is_gap) {
            // A change across a gap in the readings must not be reported as a slow step.
            path_.clear();
            gap_end_ = reading.arrival;
        }
        if (!gap_end_ || reading.arrival - *gap_end_ >= kWaitingComes
            || reading.arrival < *gap_end_)
            path_.push_back({ reading.arrival, reading.height_mm });
    }
    if (believed_.empty() || path_.empty())
        return;
    auto const newest = path_.back().time;
    while (newest - path_.front().time > 2 * kSide + kStepTakes)
        path_.pop_front();
    auto const after = line_through(path_, newest, {}, kSide);
    auto const before = line_through(path_, newest, kSide + kStepTakes, 2 * kSide + kStepTakes);
    if (std::min(after.count, before.count) < kMinForStep
        || std::abs(after.mm_per_s - before.mm_per_s) > limits_.step_speed_mm_per_s)
        return;
    double const way_mm = (after.mm_per_s + before.mm_per_s) / 2 * (after.seconds - before.seconds);
    double const step_mm = after.mm - before.mm - way_mm;
    double const scatter_mm = std::max(after.scatter_mm, before.scatter_mm);
    auto const when = newest - kSide - kStepTakes / 2;
    if (std::abs(step_mm) > limits_.step_mm + limits_.step_scatters * scatter_mm)
        see({ .kind = HeightFaultKind::Jump,
              .begin = when,
              .end = when,
              .counts = sample.counts,
              .step_mm = step_mm });
}

void HeightMonitor::watch_slow_slip(drivers::HeightSample const& sample)
{
    double const count_mm = std::abs(mm_per_count_at(rig_.height_model, sample.counts).value_or(0));
    // A converter too coarse to show noise makes corners of every movement.
    bool const has_noise = flickers_ >= kNoisyFlickers;
    for (auto const& reading : thinned_) {
        auto const slip = slow_slip_.push(reading.arrival, reading.height_mm, count_mm);
        if (slip && has_noise)
            see({ .kind = HeightFaultKind::Jump,
                  .begin = slip->begin,
                  .end = slip->end,
                  .counts = sample.counts,
                  .step_mm = slip->step_mm });
    }
}

void HeightMonitor::watch_stop(drivers::HeightSample const& sample)
{
    auto const height = height_of(sample);
    if (!height)
        return;
    auto const tell = [&](LowestStop::Moved const& moved, double sign) {
        see({ .kind = HeightFaultKind::Stop,
              .begin = moved.time,
              .end = moved.time,
              .counts = sample.counts,
              .step_mm = sign * (moved.to_mm - moved.from_mm),
              .is_highest_stop = sign < 0 });
    };
    if (auto const moved = lowest_stop_.push(sample.time, *height))
        tell(*moved, 1);
    if (auto const moved = highest_stop_.push(sample.time, -*height))
        tell(*moved, -1);
}

void HeightMonitor::learn_noise(drivers::HeightSample const& sample)
{
    int const sign = sample.counts > last_->counts ? 1 : -1;
    if (sign == -last_change_sign_ && sample.time - last_change_ < kFlicker)
        ++flickers_;
    last_change_ = sample.time;
    last_change_sign_ = sign;
}

// Detects a stuck sensor. A reading on a rail has no noise, and is a fault already.
void HeightMonitor::watch_stuck(drivers::HeightSample const& sample)
{
    bool const is_same = last_ && last_->counts == sample.counts;
    if (last_ && !is_same)
        learn_noise(sample);
    if (!is_same || is_on_rail(sample)) {
        same_since_ = sample.time;
        close(HeightFaultKind::Stuck);
        return;
    }
    auto const limit
        = flickers_ >= kNoisyFlickers ? limits_.stuck_after : limits_.stuck_without_noise_after;
    if (sample.time - same_since_ >= limit)
        see({ .kind = HeightFaultKind::Stuck,
              .begin = same_since_,
              .end = sample.time,
              .counts = sample.counts });
}

void HeightMonitor::watch_rate(Timestamp time)
{
    constexpr Duration kSpan = std::chrono::seconds(1);
    // Most readings remembered; USB allows 8,000 a second.
    constexpr std::size_t kMaxPerSecond = 20'000;
    if (!recent_.empty() && time < recent_.back())
        recent_.clear(); // Times go back in concatenated logs.
    recent_.push_back(time);
    while (time - recent_.front() > kSpan || recent_.size() > kMaxPerSecond)
        recent_.pop_front();
}

double HeightMonitor::rate_hz() const
{
    if (recent_.size() < 2 || recent_.back() <= recent_.front())
        return 0;
    return static_cast<double>(recent_.size() - 1) / to_seconds(recent_.back() - recent_.front());
}

std::optional<HeightFault> HeightMonitor::present() const
{
    for (auto const& one : watches_)
        if (one.open)
            return one.open;
    return std::nullopt;
}

HeightFaultTotal HeightMonitor::total(HeightFaultKind kind) const
{
    auto const& [open, closed] = watch(kind);
    auto result = closed;
    if (open)
        add(result, *open);
    return result;
}

} // namespace tractus::calib
