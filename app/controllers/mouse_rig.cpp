#include "app/controllers/mouse_rig.h"

#include "drivers/pens/known_habits.h"
#include "engine/base/check.h"
#include "sim/simulated_height.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace tractus::controllers {

namespace {

constexpr double kCountsPerSurfaceMm = 200;
// Counts at the surface's lowest and greatest height. They keep a distance from the ends of the
// sensor's range, where readings mean a fault.
constexpr std::int32_t kSurfaceLow = 1000;
constexpr std::int32_t kSurfaceHigh = 61000;
constexpr std::int32_t kSurfaceFullScale = 62000;
static_assert((kSurfaceHigh - kSurfaceLow) / kCountsPerSurfaceMm == MouseRig::kTop_mm);
// Within this time of the beginning and end of a stall, heights are sent at the normal rate, as pen
// positions have times in this part and a moving surface comes to rest in it.
constexpr Duration kDenseAroundStall = std::chrono::milliseconds(250);
// Maximum number of height reports for the middle of a stall, even if it lasts hours.
constexpr Duration::rep kMaxOfStall = 10'000;

} // namespace

struct MouseRig::Shared {
    std::function<Timestamp()> now;
    double wanted_mm = 0;  // The surface's target height.
    double surface_mm = 0; // The surface's current height.

    bool has_tablet = false;                // True if the mouse replaces the tablet.
    std::deque<drivers::RawReport> reports; // Reports of the pen that have not been read yet.
    Timestamp last_move {};                 // Time of the pen's newest report.
    Timestamp last_reading {};  // Time at which pending heights were last read completely.
    Timestamp heights_until {}; // Heights have been sent up to this time.

    // Time up to which heights may be sent. The pen's next reports get times after its newest
    // report or after the last reading, and reports must be in time order.
    Timestamp telling_end() const { return has_tablet ? std::max(last_move, last_reading) : now(); }
};

namespace {

class MouseTablet final : public drivers::ReportSource {
public:
    explicit MouseTablet(std::shared_ptr<MouseRig::Shared> shared)
        : shared_(std::move(shared))
        , info_(sim::simulated_tablet_info(MouseRig::rig().tablet_size_mm))
    {
        info_.name = "Mouse as a pen";
        info_.product_id = drivers::kMousePenProduct;
        info_.location = "mouse";
    }

    drivers::DeviceInfo const& info() const override { return info_; }

    Result<std::optional<drivers::RawReport>> read(Duration) override
    {
        if (shared_->reports.empty())
            return std::optional<drivers::RawReport>();
        auto const report = shared_->reports.front();
        shared_->reports.pop_front();
        return report;
    }

private:
    std::shared_ptr<MouseRig::Shared> shared_;
    drivers::DeviceInfo info_;
};

// Height sensor that sends the surface's height repeatedly, with one count of noise.
class MouseSurface final : public drivers::ReportSource {
public:
    explicit MouseSurface(std::shared_ptr<MouseRig::Shared> shared)
        : shared_(std::move(shared))
        , info_(sim::simulated_slider_info(kSurfaceFullScale))
    {
        info_.name = "Surface moved by mouse or keys";
        info_.location = "mouse";
    }

    drivers::DeviceInfo const& info() const override { return info_; }

    Result<std::optional<drivers::RawReport>> read(Duration) override
    {
        auto const end = shared_->telling_end();
        shared_->heights_until = end;
        if (!next_)
            next_ = end;
        if (*next_ > end) {
            shared_->last_reading = shared_->now();
            begin_ = *next_;
            return std::optional<drivers::RawReport>();
        }
        auto const time = *next_;
        *next_ += period(time, end);
        auto const counts = std::lround(glide_to(time) * kCountsPerSurfaceMm);
        return sim::simulated_slider_report(
            with_noise(kSurfaceLow + static_cast<std::int32_t>(counts)), time);
    }

private:
    // Time from the report at `time` to the next, in a series of reports that lasts until `end`.
    Duration period(Timestamp time, Timestamp end) const
    {
        auto const sparse
            = std::max<Duration>(MouseRig::kStalledHeightPeriod, (end - begin_) / kMaxOfStall);
        bool const is_dense
            = time - begin_ < kDenseAroundStall || end - time < kDenseAroundStall + sparse;
        return is_dense ? Duration(MouseRig::kHeightPeriod) : sparse;
    }

    // Adds noise of one count to every second reading, towards the middle of the range: a sensor
    // without noise would be taken for a broken cable.
    std::int32_t with_noise(std::int32_t counts)
    {
        flickers_ = !flickers_;
        std::int32_t const inwards = counts < (kSurfaceLow + kSurfaceHigh) / 2 ? 1 : -1;
        return counts + (flickers_ ? inwards : 0);
    }

    // Moves the surface until `now` and returns its height. The surface slows down near its target.
    double glide_to(Timestamp now)
    {
        constexpr double kGlide_s = 0.04;
        double const step_s = last_ ? to_seconds(now - *last_) : 0;
        last_ = now;
        double const wanted_mm = shared_->wanted_mm;
        double const way_mm = wanted_mm - shared_->surface_mm;
        double const farthest_mm = MouseRig::kFastest_mm_per_s * step_s;
        double const step_mm
            = std::clamp(way_mm * (1 - std::exp(-step_s / kGlide_s)), -farthest_mm, farthest_mm);
        bool const is_there = std::abs(way_mm - step_mm) < 0.5 / kCountsPerSurfaceMm;
        shared_->surface_mm = is_there ? wanted_mm : shared_->surface_mm + step_mm;
        return shared_->surface_mm;
    }

    std::shared_ptr<MouseRig::Shared> shared_;
    drivers::DeviceInfo info_;
    std::optional<Timestamp> next_; // Time at which the next height is due.
    Timestamp begin_ {};            // Time of the first height in the series that is being read.
    std::optional<Timestamp> last_; // Time at which a height was last sent.
    bool flickers_ = false;
};

} // namespace

MouseRig::MouseRig(std::function<Timestamp()> now)
    : shared_(std::make_shared<Shared>())
{
    CHECK(now);
    shared_->now = std::move(now);
    shared_->last_move = shared_->now();
    shared_->last_reading = shared_->last_move;
    shared_->heights_until = shared_->last_move;
}

calib::Rig MouseRig::rig()
{
    calib::Rig rig;
    set_height_sensor_in(rig);
    return rig;
}

void MouseRig::set_height_sensor_in(calib::Rig& rig)
{
    rig.height_model = calib::LinearHeight { .mm_per_count = 1 / kCountsPerSurfaceMm,
                                             .zero_counts = kSurfaceLow };
    rig.full_scale_counts = kSurfaceFullScale;
    rig.calibrated_min_counts = kSurfaceLow;
    rig.calibrated_max_counts = kSurfaceHigh;
    rig.height_latency = {};
}

std::unique_ptr<drivers::ReportSource> MouseRig::open_tablet() const
{
    shared_->has_tablet = true;
    return std::make_unique<MouseTablet>(shared_);
}

std::unique_ptr<drivers::ReportSource> MouseRig::open_height() const
{
    return std::make_unique<MouseSurface>(shared_);
}

void MouseRig::move_pen(std::span<sim::TabletPen const> pens)
{
    if (!shared_->has_tablet)
        return;
    auto const now = shared_->now();
    // Maximum time over which a movement is spread. If the last frame is longer ago, as after a
    // pause, the movement is assumed to have just begun.
    constexpr Duration kLongestFrame = std::chrono::milliseconds(100);
    auto const begin
        = std::max({ shared_->last_move, shared_->heights_until, now - kLongestFrame });
    auto const since = std::max<Duration>(now - begin, Duration::zero());
    shared_->last_move = std::max(now, shared_->last_move);
    auto const size_mm = rig().tablet_size_mm;
    for (std::size_t i = 0; i < pens.size(); ++i) {
        auto const left = static_cast<std::int64_t>(pens.size() - 1 - i);
        auto const received = now - since * left / static_cast<std::int64_t>(pens.size());
        shared_->reports.push_back(sim::simulated_tablet_report(pens[i], size_mm, received));
    }
}

void MouseRig::move_surface(double by_mm)
{
    shared_->wanted_mm = std::clamp(shared_->wanted_mm + by_mm, 0.0, kTop_mm);
}

void MouseRig::set_surface(double height_mm)
{
    shared_->wanted_mm = std::clamp(height_mm, 0.0, kTop_mm);
    shared_->surface_mm = shared_->wanted_mm;
}

} // namespace tractus::controllers
