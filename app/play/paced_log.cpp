#include "app/play/paced_log.h"

#include "drivers/logs/log_source.h"
#include "drivers/reports/clock.h"
#include "engine/base/check.h"

#include <algorithm>
#include <fmt/core.h>
#include <thread>
#include <utility>

namespace tractus::play {

namespace {

class PacedSource final : public drivers::ReportSource {
public:
    PacedSource(std::shared_ptr<drivers::Log const> log, std::size_t device, Pace pace)
        : log_(std::move(log))
        , source_(*log_, device)
        , pace_(std::move(pace))
    {
    }

    drivers::DeviceInfo const& info() const override { return source_.info(); }

    Result<std::optional<drivers::RawReport>> read(Duration timeout) override
    {
        if (!next_)
            next_ = TRY(source_.read(Duration::zero()));
        if (!next_)
            return fail(Fault::User, fmt::format("{} is over", info().location));
        auto const due = pace_.real_time(next_->received);
        auto const left = due - pace_.now();
        if (left > Duration::zero())
            pace_.wait(std::min(left, timeout));
        if (left > timeout)
            return std::optional<drivers::RawReport>();
        auto report = std::exchange(next_, std::nullopt);
        report->received = due;
        return report;
    }

private:
    std::shared_ptr<drivers::Log const> log_;
    drivers::LogSource source_; // Returns the device's reports from the log.
    Pace pace_;
    // The next report, read early; its time has not come yet.
    std::optional<drivers::RawReport> next_;
};

} // namespace

Timestamp Pace::real_time(Timestamp data) const
{
    return real_begin + from_seconds(to_seconds(data - data_begin) / speed);
}

Timestamp Pace::data_time(Timestamp real) const
{
    return data_begin + from_seconds(to_seconds(real - real_begin) * speed);
}

Pace pace_from_now(Timestamp data_begin, double speed)
{
    return { .data_begin = data_begin,
             .real_begin = drivers::monotonic_now(),
             .speed = speed,
             .now = drivers::monotonic_now,
             .wait = [](Duration duration) { std::this_thread::sleep_for(duration); } };
}

std::unique_ptr<drivers::ReportSource> open_paced(std::shared_ptr<drivers::Log const> log,
                                                  std::size_t device, Pace pace)
{
    CHECK(pace.speed > 0 && pace.now && pace.wait);
    return std::make_unique<PacedSource>(std::move(log), device, std::move(pace));
}

} // namespace tractus::play
