#include "sim/simulated_device.h"

#include "engine/base/check.h"

#include <algorithm>
#include <utility>

namespace tractus::sim {

DeviceClock::DeviceClock(DeviceTiming const& timing, RandomKey const& key)
    : timing_(timing)
    , random_(key)
{
    CHECK(timing.period > Duration(0));
    next_ += from_seconds(random_.uniform() * to_seconds(timing.period));
}

Timestamp DeviceClock::next_instant()
{
    return std::exchange(next_, next_ + timing_.period);
}

Timestamp DeviceClock::arrival(Timestamp instant)
{
    // Limit of the latency's deviation from its mean, in standard deviations.
    constexpr double kFarthest = 3;
    constexpr Duration kTransferTime = std::chrono::microseconds(50);
    double const deviations = std::clamp(random_.normal(), -kFarthest, kFarthest);
    auto const arrival
        = instant + timing_.latency + from_seconds(deviations * to_seconds(timing_.jitter));
    last_arrival_ = std::max({ arrival, instant, last_arrival_ + kTransferTime });
    return last_arrival_;
}

class SimulatedSource : public drivers::ReportSource {
public:
    SimulatedSource(SimulatedDevice device, Pacer pacer)
        : device_(std::move(device))
        , pacer_(std::move(pacer))
    {
    }

    drivers::DeviceInfo const& info() const override { return device_.info; }

    Result<std::optional<drivers::RawReport>> read(Duration timeout) override
    {
        bool const ended = next_ == device_.reports.size();
        auto const due = ended ? Timestamp::max() : device_.reports[next_].received;
        bool const is_due = !pacer_ || pacer_(due, timeout);
        if (ended || !is_due)
            return std::optional<drivers::RawReport>();
        return std::optional(device_.reports[next_++]);
    }

private:
    SimulatedDevice device_;
    Pacer pacer_;
    std::size_t next_ = 0;
};

std::unique_ptr<drivers::ReportSource> open_simulated(SimulatedDevice device, Pacer pacer)
{
    return std::make_unique<SimulatedSource>(std::move(device), std::move(pacer));
}

std::vector<ArrivedReport> in_order_of_arrival(std::span<SimulatedDevice const* const> devices)
{
    std::vector<ArrivedReport> arrived;
    for (std::size_t i = 0; i < devices.size(); ++i)
        for (auto const& report : devices[i]->reports)
            arrived.push_back({ .device = i, .report = &report });
    std::stable_sort(arrived.begin(), arrived.end(), [](auto const& a, auto const& b) {
        return a.report->received < b.report->received;
    });
    return arrived;
}

} // namespace tractus::sim
