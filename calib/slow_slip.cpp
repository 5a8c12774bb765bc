#include "calib/slow_slip.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tractus::calib {

namespace {

using Eigen::VectorXd;

// Least time in which a hand changes a surface's speed: half a period of the fastest tremor.
constexpr double kHand_s = 0.05;
constexpr double kHand_hz = 12; // Greatest frequency of a movement, for the polynomial's degree.
constexpr int kMinDegree = 4;

constexpr double kRemembered_s = 0.7;
constexpr double kGap_s = 0.03; // Longer intervals between readings are gaps.

// Half the width of the matched filter, and the interval at which it is evaluated.
constexpr double kReach_s = 0.04;
constexpr double kCornerStep_s = 0.005;
constexpr int kMinReadingsBeside = 3; // Least number of readings on either side of a corner.
// Opposite corners may differ by this factor, because movements add to them.
constexpr double kMaxCornerRatio = 4;

constexpr double kShortest_s = 0.006;
constexpr double kLongest_s = 0.3;
constexpr double kBeside_s = 0.08; // Time before and after a slip that is explained with it.
constexpr Eigen::Index kMinFreedomOfSlip = 8;
constexpr double kMaxExcess = 2; // Greatest variance left by a slip, as a multiple of the noise's.

// Least noise of a reading: as a share of a count, and for very fine converters.
constexpr double kNoiseOfCount = 0.35;
constexpr double kMinNoise_mm = 0.01;

// Returns the integral of a speed that rises evenly from 0 to 1, over `takes_s` about `corner_s`.
double ramp(double seconds, double corner_s, double takes_s)
{
    double const since_s = seconds - corner_s;
    if (since_s >= takes_s / 2)
        return std::max(0.0, since_s);
    double const into_s = std::max(0.0, since_s + takes_s / 2);
    return takes_s > 0 ? into_s * into_s / (2 * takes_s) : 0;
}

struct Push {
    double begin_s = 0;
    double end_s = 0;
    // Times that the two changes of speed take.
    double begin_takes_s = 0;
    double end_takes_s = 0;
};

// Returns orthonormal polynomials up to a degree, a column each, at times from -1 to 1.
Eigen::MatrixXd polynomials(VectorXd const& times, Eigen::Index degree)
{
    Eigen::MatrixXd basis(times.size(), degree + 1);
    VectorXd column = VectorXd::Ones(times.size());
    for (Eigen::Index i = 0; i <= degree; ++i) {
        if (i > 0)
            column = basis.col(i - 1).cwiseProduct(times);
        // Orthogonalised twice against rounding errors.
        for (int twice = 0; twice < 2; ++twice)
            column -= basis.leftCols(i) * (basis.leftCols(i).transpose() * column);
        basis.col(i) = column.normalized();
    }
    return basis;
}

// Returns the degree of a polynomial that can follow a hand for this time.
Eigen::Index degree_for(double length_s)
{
    return std::max<Eigen::Index>(kMinDegree, std::lround(2 * kHand_hz * length_s));
}

// By how much a shape reduces the sum of squares that the movement leaves, and its speed.
struct Gain {
    double mm2 = 0;
    double mm_per_s = 0;
};

// Returns the gain of a shape, given by its values, for heights of which `rest_mm` is left without
// the movement, which the columns of `basis` span.
Gain gain_of_shape(VectorXd const& values, Eigen::MatrixXd const& basis, VectorXd const& rest_mm)
{
    constexpr double kLeastPart = 1e-9; // A smaller part of a shape is rounding error.
    double const all = values.squaredNorm();
    double const beside = all - (basis.transpose() * values).squaredNorm();
    if (!(beside > kLeastPart * all))
        return {};
    double const product = values.dot(rest_mm);
    return { product * product / beside, product / beside };
}

// The heights in a window, explained by a smooth movement and one shape in addition.
class Window {
public:
    Window(VectorXd const& seconds, VectorXd const& mm)
        : seconds_(seconds)
    {
        double const middle_s = (first_s() + last_s()) / 2;
        double const length_s = last_s() - first_s();
        basis_ = polynomials((seconds.array() - middle_s) * (2 / length_s), degree_for(length_s));
        rest_mm_ = mm - basis_ * (basis_.transpose() * mm);
    }

    double first_s() const { return seconds_[0]; }
    double last_s() const { return seconds_[seconds_.size() - 1]; }
    double squares_mm2() const { return rest_mm_.squaredNorm(); }
    Eigen::Index freedom() const { return seconds_.size() - basis_.cols(); }

    Gain gain_of(Push const& push) const
    {
        return gain([&](double seconds) {
            return ramp(seconds, push.begin_s, push.begin_takes_s)
                - ramp(seconds, push.end_s, push.end_takes_s);
        });
    }

    Gain gain_of_corner(double corner_s) const
    {
        return gain([&](double seconds) { return ramp(seconds, corner_s, 0); });
    }

private:
    template<typename Shape> Gain gain(Shape const& shape) const
    {
        return gain_of_shape(seconds_.unaryExpr(shape), basis_, rest_mm_);
    }

    VectorXd seconds_;
    Eigen::MatrixXd basis_; // Orthonormal polynomials.
    VectorXd rest_mm_;      // Heights without the movement.
};

// A first look at a pair of corners, on evenly spaced heights in place of all readings. A hand that
// trembles makes hundreds of pairs a second, which take too long to be judged all.
constexpr Eigen::Index kGrid = 48;
using GridVector = Eigen::Matrix<double, kGrid, 1>;

Eigen::MatrixXd const& grid_basis(Eigen::Index degree)
{
    static auto const bases = [] {
        std::vector<Eigen::MatrixXd> made;
        for (Eigen::Index each = 0; each <= degree_for(kLongest_s + 2 * kBeside_s); ++each)
            made.push_back(polynomials(GridVector::LinSpaced(-1, 1), each));
        return made;
    }();
    return bases[std::min(static_cast<std::size_t>(degree), bases.size() - 1)];
}

// Returns the heights at evenly spaced times of a window, interpolated between the readings from
// `before`, the last one before the window, to `last`, the first one after it.
template<typename Iterator>
GridVector heights_on_grid(Iterator before, Iterator last, double begin_s, double step_s)
{
    GridVector mm;
    for (Eigen::Index i = 0; i < kGrid; ++i) {
        double const at_s = begin_s + static_cast<double>(i) * step_s;
        while (before + 1 != last && before[1].seconds < at_s)
            ++before;
        double const part = (at_s - before->seconds) / (before[1].seconds - before->seconds);
        mm[i] = before->mm + part * (before[1].mm - before->mm);
    }
    return mm;
}

// False if the heights on the grid already show that there is no slip at about these times.
bool is_promising(GridVector const& mm, Push const& slip, double noise_mm)
{
    constexpr double kMinShare = 0.7; // Least share of the unevenness that a slip explains.
    double const begin_s = slip.begin_s - kBeside_s;
    double const length_s = slip.end_s + kBeside_s - begin_s;
    auto const& basis = grid_basis(degree_for(length_s));
    auto const freedom = static_cast<double>(kGrid - basis.cols());
    VectorXd const rest_mm = mm - basis * (basis.transpose() * mm);
    double const uneven_mm2 = rest_mm.squaredNorm() - kMaxExcess * noise_mm * noise_mm * freedom;
    VectorXd const shape = VectorXd::NullaryExpr(kGrid, [&](Eigen::Index i) {
        double const seconds = begin_s + static_cast<double>(i) * length_s / (kGrid - 1);
        return ramp(seconds, slip.begin_s, 0) - ramp(seconds, slip.end_s, 0);
    });
    auto const gain = gain_of_shape(shape, basis, rest_mm);
    double const speed_mm_per_s = std::abs(gain.mm_per_s);
    return gain.mm2 > kMinShare * uneven_mm2 && speed_mm_per_s > SlowSlip::kMinSpeed_mm_per_s / 2
        && speed_mm_per_s * (slip.end_s - slip.begin_s) > SlowSlip::kMinStep_mm / 2;
}

// Moves both corners of a push to where it explains the most.
void settle(Push& push, Window const& window)
{
    constexpr double kFirstStep_s = 0.004;
    constexpr double kLastStep_s = 0.0005;
    constexpr int kMaxMoves = 20;
    double best_mm2 = window.gain_of(push).mm2;
    for (double step_s = kFirstStep_s; step_s >= kLastStep_s; step_s /= 2)
        for (int moves = 0; moves < kMaxMoves; ++moves) {
            double const before_mm2 = best_mm2;
            for (auto* const corner_s : { &push.begin_s, &push.end_s })
                for (double const by_s : { step_s, -step_s }) {
                    double const old_s = *corner_s;
                    *corner_s += by_s;
                    bool const is_within = push.begin_s >= window.first_s() + kBeside_s / 2
                        && push.end_s <= window.last_s() - kBeside_s / 2
                        && push.end_s - push.begin_s >= kShortest_s;
                    double const gain_mm2 = is_within ? window.gain_of(push).mm2 : 0;
                    if (gain_mm2 > best_mm2)
                        best_mm2 = gain_mm2;
                    else
                        *corner_s = old_s;
                }
            if (best_mm2 == before_mm2)
                break;
        }
}

// Returns how much the best explanation other than a slip reduces the sum of squares.
double best_other_mm2(Push const& slip, Window const& window)
{
    constexpr double kStep_s = 0.006;
    double best_mm2 = 0;
    for (double at_s = window.first_s() + kStep_s; at_s < window.last_s(); at_s += kStep_s)
        best_mm2 = std::max(best_mm2, window.gain_of_corner(at_s).mm2);
    double const whole_s = slip.end_s - slip.begin_s;
    for (double const begin_takes_s : { 0.0, kHand_s, whole_s })
        for (double const end_takes_s : { 0.0, kHand_s, whole_s })
            if (std::max(begin_takes_s, end_takes_s) >= kHand_s)
                best_mm2 = std::max(
                    best_mm2,
                    window.gain_of({ slip.begin_s, slip.end_s, begin_takes_s, end_takes_s }).mm2);
    return best_mm2;
}

} // namespace

void SlowSlip::clear()
{
    while (!heights_.empty())
        forget_oldest();
    corners_.clear();
}

void SlowSlip::forget_oldest()
{
    double const mm = heights_.front().mm;
    lowest_mm_ = std::min(lowest_mm_, mm);
    highest_mm_ = std::max(highest_mm_, mm);
    heights_.pop_front();
}

// True if the surface rests after an instant where it has met a stop before: then the stop, and no
// slip, is what ended its movement.
bool SlowSlip::meets_stop(double seconds) const
{
    constexpr double kSamePlace_mm = 1;
    return std::all_of(heights_.rbegin(), heights_.rend(), [&](Height const& height) {
        return height.seconds < seconds + kCornerStep_s
            || std::min(std::abs(height.mm - lowest_mm_), std::abs(height.mm - highest_mm_))
            < kSamePlace_mm;
    });
}

Timestamp SlowSlip::time_at(double seconds) const
{
    return origin_ + Duration(std::llround(seconds * 1e9));
}

// Fits the heights about an instant with a parabola and one corner.
std::optional<SlowSlip::Corner> SlowSlip::corner_at(double seconds) const
{
    Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
    Eigen::Vector4d products = Eigen::Vector4d::Zero();
    int before = 0;
    int after = 0;
    for (auto height = heights_.rbegin(); height != heights_.rend(); ++height) {
        double const since = (height->seconds - seconds) / kReach_s;
        if (since > 1)
            continue;
        if (since < -1)
            break;
        ++(since < 0 ? before : after);
        Eigen::Vector4d const row(1, since, since * since, std::max(0.0, since));
        squares += row * row.transpose();
        products += row * (height->mm - heights_.back().mm);
    }
    if (std::min(before, after) < kMinReadingsBeside)
        return std::nullopt;
    return Corner { seconds, squares.inverse().row(3).dot(products) / kReach_s };
}

// Returns the standard deviation of a reading, from the median of third differences.
double SlowSlip::noise_mm() const
{
    constexpr double kMedian = 0.6745;      // Median of a normal distribution's absolute values.
    constexpr double kThirdDifference = 20; // Its variance in those of a reading.
    std::vector<double> bends_mm;
    for (std::size_t i = 3; i < heights_.size(); ++i)
        bends_mm.push_back(std::abs(heights_[i].mm - heights_[i - 3].mm
                                    - 3 * (heights_[i - 1].mm - heights_[i - 2].mm)));
    double const least_mm = std::max(kMinNoise_mm, kNoiseOfCount * count_mm_);
    if (bends_mm.empty())
        return least_mm;
    auto const middle = bends_mm.begin() + static_cast<std::ptrdiff_t>(bends_mm.size() / 2);
    std::nth_element(bends_mm.begin(), middle, bends_mm.end());
    return std::max(least_mm, *middle / kMedian / std::sqrt(kThirdDifference));
}

// True if no corner within 10 ms is greater, in the same direction.
bool SlowSlip::is_peak(std::size_t corner) const
{
    constexpr std::size_t kNeighbours = 2;
    double const sign = corners_[corner].mm_per_s < 0 ? -1 : 1;
    auto const first = corner - std::min(corner, kNeighbours);
    auto const end = std::min(corners_.size(), corner + kNeighbours + 1);
    for (auto other = first; other < end; ++other)
        if (sign * corners_[other].mm_per_s > sign * corners_[corner].mm_per_s)
            return false;
    return true;
}

// Compares a slip from about `begin_s` to about `end_s` with the other explanations. No value if
// there are too few readings, or if the slip is certainly not to be reported.
std::optional<SlowSlip::Slip> SlowSlip::judge(double begin_s, double end_s) const
{
    auto const at = [](Height const& height, double seconds) { return height.seconds < seconds; };
    auto const first = std::lower_bound(heights_.begin(), heights_.end(), begin_s - kBeside_s, at);
    auto const last = std::lower_bound(first, heights_.end(), end_s + kBeside_s, at);
    bool const is_whole = first != heights_.begin() && last != heights_.end();
    auto const size = static_cast<Eigen::Index>(last - first);
    Push push { begin_s, end_s };
    double const step_s = (end_s - begin_s + 2 * kBeside_s) / (kGrid - 1);
    if (!is_whole || size < kMinFreedomOfSlip + kMinDegree + 1
        || !is_promising(heights_on_grid(first - 1, last, begin_s - kBeside_s, step_s), push,
                         noise_mm_))
        return std::nullopt;
    VectorXd seconds(size);
    VectorXd mm(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        seconds[i] = first[i].seconds;
        mm[i] = first[i].mm;
    }
    Window const window(seconds, mm);
    double const noise_mm2 = noise_mm_ * noise_mm_;
    if (window.freedom() < kMinFreedomOfSlip
        || window.gain_of(push).mm2 < min_evidence_ / 2 * noise_mm2)
        return std::nullopt;
    settle(push, window);
    auto const gain = window.gain_of(push);
    // The slip's speed and its two times are estimated, too.
    double const left_mm2
        = (window.squares_mm2() - gain.mm2) / static_cast<double>(window.freedom() - 3);
    double const variance_mm2 = std::max(noise_mm2, left_mm2);
    double const step_mm = gain.mm_per_s * (push.end_s - push.begin_s);
    if (gain.mm2 < min_evidence_ * variance_mm2 || variance_mm2 > kMaxExcess * noise_mm2
        || std::abs(step_mm) < kMinStep_mm || std::abs(gain.mm_per_s) < kMinSpeed_mm_per_s
        || meets_stop(push.end_s))
        return std::nullopt;
    return Slip { .begin = time_at(push.begin_s),
                  .end = time_at(push.end_s),
                  .step_mm = step_mm,
                  .evidence = (gain.mm2 - best_other_mm2(push, window)) / variance_mm2 };
}

// Returns the likeliest of the slips that end at a corner.
std::optional<SlowSlip::Slip> SlowSlip::best_slip(Corner const& end) const
{
    std::optional<Slip> best;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        auto const& begin = corners_[i];
        double const lasts_s = end.seconds - begin.seconds;
        double const ratio = -begin.mm_per_s / end.mm_per_s;
        if (lasts_s < kShortest_s || lasts_s > kLongest_s || begin.seconds < told_until_s_
            || ratio < 1 / kMaxCornerRatio || ratio > kMaxCornerRatio || !is_peak(i))
            continue;
        auto const slip = judge(begin.seconds, end.seconds);
        if (slip && (!best || slip->evidence > best->evidence))
            best = slip;
    }
    return best;
}

std::optional<SlowSlip::Slip> SlowSlip::push(Timestamp time, double height_mm, double count_mm)
{
    // A corner can end a slip once the readings kBeside_s after it have come.
    constexpr auto kLater
        = static_cast<std::size_t>((kBeside_s - kReach_s) / kCornerStep_s + 0.5) + 1;
    constexpr double kMinCorner_mm_per_s = kMinSpeed_mm_per_s / 3;
    double now_s = to_seconds(time - origin_);
    if (!heights_.empty()
        && (now_s <= heights_.back().seconds || now_s - heights_.back().seconds > kGap_s))
        clear();
    if (heights_.empty()) {
        origin_ = time;
        now_s = next_corner_s_ = next_noise_s_ = told_until_s_ = 0;
    }
    count_mm_ = count_mm;
    heights_.push_back({ now_s, height_mm });
    while (heights_.front().seconds < now_s - kRemembered_s)
        forget_oldest();
    constexpr double kNoiseLasts_s = 0.25;
    if (now_s >= next_noise_s_) {
        noise_mm_ = noise_mm();
        next_noise_s_ = now_s + kNoiseLasts_s;
    }
    std::optional<Slip> found;
    for (; next_corner_s_ + kReach_s <= now_s; next_corner_s_ += kCornerStep_s) {
        auto const corner = corner_at(next_corner_s_);
        if (!corner)
            continue;
        corners_.push_back(*corner);
        while (corners_.front().seconds < now_s - kRemembered_s)
            corners_.pop_front();
        if (corners_.size() <= kLater)
            continue;
        auto const end = corners_.size() - 1 - kLater;
        if (std::abs(corners_[end].mm_per_s) < kMinCorner_mm_per_s || !is_peak(end))
            continue;
        auto const slip = best_slip(corners_[end]);
        if (!slip || slip->evidence < min_evidence_)
            continue;
        told_until_s_ = now_s;
        found = slip;
    }
    return found;
}

} // namespace tractus::calib
