#include "calib/lowest_stop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::calib {

namespace {

constexpr Duration kRests = std::chrono::milliseconds(300);
constexpr double kRestTolerance_mm = 0.5;
// A surface counts as let down only if it comes from at least this far above its resting height.
constexpr double kComesFrom_mm = 10;
constexpr double kSamePositionTolerance_mm = 0.3;
constexpr double kBelow_mm = 1;   // A height this far below a resting place counts as below it.
constexpr double kMinMove_mm = 2; // Least movement of the stop that is reported.
// Greatest rise of the stop that is reported; a surface resting higher was held, not let down.
constexpr double kMaxMove_mm = 30;
constexpr std::size_t kTimesOfStop = 4;
// Rests needed at a higher place, since a hand can rest above a stop, too.
constexpr std::size_t kTimesHigher = 4;
// Rests needed at a lower place; fewer suffice, since nothing goes below a stop.
constexpr std::size_t kTimesLower = 2;

} // namespace

bool LowestStop::Place::is_at(double height_mm) const
{
    return std::abs(height_mm - mm) <= kSamePositionTolerance_mm;
}

void LowestStop::Place::add(double height_mm)
{
    mm += (height_mm - mm) / static_cast<double>(++times);
}

std::optional<LowestStop::Moved> LowestStop::push(Timestamp time, double height_mm)
{
    if (!rests_since_)
        highest_mm_ = lowest_mm_ = height_mm;
    bool const goes_on = rests_since_ && time >= *rests_since_
        && std::abs(height_mm - rest_mm_) <= kRestTolerance_mm;
    if (!goes_on) {
        rests_since_ = time;
        rest_mm_ = height_mm;
        rest_count_ = 0;
        is_rest_reported_ = false;
    }
    rest_mm_ += (height_mm - rest_mm_) / static_cast<double>(++rest_count_);
    highest_mm_ = std::max(highest_mm_, height_mm);
    lowest_mm_ = std::min(lowest_mm_, height_mm);
    if (is_rest_reported_ || time - *rests_since_ < kRests)
        return std::nullopt;
    is_rest_reported_ = true;
    double const highest_mm = std::exchange(highest_mm_, rest_mm_);
    if (highest_mm - rest_mm_ < kComesFrom_mm)
        return std::nullopt;
    auto const moved = let_down(time, rest_mm_);
    lowest_mm_ = rest_mm_;
    return moved;
}

std::optional<LowestStop::Moved> LowestStop::let_down(Timestamp time, double height_mm)
{
    bool const is_known = stop_ && stop_->times >= kTimesOfStop;
    if (stop_ && stop_->is_at(height_mm)) {
        stop_->add(height_mm);
        next_.reset();
        return std::nullopt;
    }
    if (!is_known) {
        if (!stop_ || height_mm < stop_->mm)
            stop_ = Place { height_mm, 1 };
        return std::nullopt;
    }
    double const move_mm = height_mm - stop_->mm;
    if (move_mm > kMaxMove_mm)
        return std::nullopt;
    if (next_ && next_->is_at(height_mm) && lowest_mm_ >= next_->mm - kBelow_mm)
        next_->add(height_mm);
    else
        next_ = Place { height_mm, 1 };
    if (std::abs(move_mm) < kMinMove_mm
        || next_->times < (move_mm > 0 ? kTimesHigher : kTimesLower))
        return std::nullopt;
    Moved const moved { time, stop_->mm, next_->mm };
    stop_ = Place { next_->mm, kTimesOfStop };
    next_.reset();
    return moved;
}

} // namespace tractus::calib
