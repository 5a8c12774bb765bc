#include "app/controllers/mouse_rig.h"

#include "engine/base/check.h"
#include "sim/simulated_height.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace tractus::controllers {

namespace {

constexpr double kCountsPerSurfaceMm = 200;
constexpr std::int32_t kSurfaceLow = 1000; // Away from the ends, where a reading means a fault.
constexpr std::int32_t kSurfaceHigh = 61000;
constexpr std::int32_t kSurfaceFullScale = 62000;
static_assert((kSurfaceHigh - kSurfaceLow) / kCountsPerSurfaceMm == MouseRig::kTop_mm);
constexpr std::size_t kMostWaiting = 4096; // Reports that nobody reads.

} // namespace

struct MouseRig::Shared {
    std::function<Timestamp()> now;
    std::atomic<double> wanted_mm = 0;  // Height wanted of the surface.
    std::atomic<double> surface_mm = 0; // Where it is.

    std::mutex mutex;
    std::condition_variable has_moved;
    std::deque<drivers::RawReport> reports; // Reports of the pen that are not read yet.
};

namespace {

class MouseTablet final : public drivers::ReportSource {
public:
    explicit MouseTablet(std::shared_ptr<MouseRig::Shared> shared)
        : shared_(std::move(shared))
        , info_(sim::simulated_tablet_info(MouseRig::rig().tablet_size_mm))
    {
        info_.name = "Mouse as a pen";
        info_.location = "mouse";
    }

    drivers::DeviceInfo const& info() const override { return info_; }

    Result<std::optional<drivers::RawReport>> read(Duration timeout) override
    {
        std::unique_lock lock(shared_->mutex);
        if (!shared_->has_moved.wait_for(lock, timeout, [&] { return !shared_->reports.empty(); }))
            return std::optional<drivers::RawReport>();
        auto const report = shared_->reports.front();
        shared_->reports.pop_front();
        return report;
    }

private:
    std::shared_ptr<MouseRig::Shared> shared_;
    drivers::DeviceInfo info_;
};

// Sends the present height again and again, with a little noise, as a sensor does.
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

    Result<std::optional<drivers::RawReport>> read(Duration timeout) override
    {
        auto const now = shared_->now();
        if (next_ > now && next_ - now > timeout) {
            std::this_thread::sleep_for(timeout);
            return std::optional<drivers::RawReport>();
        }
        if (next_ > now)
            std::this_thread::sleep_for(next_ - now);
        auto const received = shared_->now();
        next_ = received + MouseRig::kHeightPeriod;
        auto const counts = std::lround(glide_to(received) * kCountsPerSurfaceMm);
        return sim::simulated_slider_report(
            with_noise(kSurfaceLow + static_cast<std::int32_t>(counts)), received);
    }

private:
    // One count up and down, inwards: a sensor that rests without any noise is taken for torn.
    std::int32_t with_noise(std::int32_t counts)
    {
        flickers_ = !flickers_;
        std::int32_t const inwards = counts < (kSurfaceLow + kSurfaceHigh) / 2 ? 1 : -1;
        return counts + (flickers_ ? inwards : 0);
    }

    // The surface at `now`: the nearer, the slower.
    double glide_to(Timestamp now)
    {
        constexpr double kGlide_s = 0.04;
        double const step_s = last_ ? to_seconds(now - *last_) : 0;
        last_ = now;
        double const wanted_mm = shared_->wanted_mm;
        double const left_mm = (wanted_mm - shared_->surface_mm) * std::exp(-step_s / kGlide_s);
        bool const is_there = std::abs(left_mm) < 0.5 / kCountsPerSurfaceMm;
        shared_->surface_mm = is_there ? wanted_mm : wanted_mm - left_mm;
        return shared_->surface_mm;
    }

    std::shared_ptr<MouseRig::Shared> shared_;
    drivers::DeviceInfo info_;
    Timestamp next_ {};
    std::optional<Timestamp> last_; // When the height was last sent.
    bool flickers_ = false;
};

} // namespace

MouseRig::MouseRig(std::function<Timestamp()> now)
    : shared_(std::make_shared<Shared>())
{
    CHECK(now);
    shared_->now = std::move(now);
    last_move_ = shared_->now();
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
    return std::make_unique<MouseTablet>(shared_);
}

std::unique_ptr<drivers::ReportSource> MouseRig::open_height() const
{
    return std::make_unique<MouseSurface>(shared_);
}

void MouseRig::move_pen(std::span<sim::TabletPen const> pens)
{
    auto const now = shared_->now();
    // After a rest it has only just begun to move.
    constexpr Duration kLongestFrame = std::chrono::milliseconds(100);
    auto const since = std::min<Duration>(now - std::exchange(last_move_, now), kLongestFrame);
    auto const size_mm = rig().tablet_size_mm;
    {
        std::scoped_lock const lock(shared_->mutex);
        for (std::size_t i = 0; i < pens.size() && shared_->reports.size() < kMostWaiting; ++i) {
            auto const left = static_cast<std::int64_t>(pens.size() - 1 - i);
            auto const received = now - since * left / static_cast<std::int64_t>(pens.size());
            shared_->reports.push_back(sim::simulated_tablet_report(pens[i], size_mm, received));
        }
    }
    shared_->has_moved.notify_all();
}

void MouseRig::move_surface(double by_mm)
{
    shared_->wanted_mm = std::clamp(shared_->wanted_mm + by_mm, 0.0, kTop_mm);
}

void MouseRig::set_surface(double height_mm)
{
    shared_->wanted_mm = std::clamp(height_mm, 0.0, kTop_mm);
    shared_->surface_mm.store(shared_->wanted_mm);
}

} // namespace tractus::controllers
