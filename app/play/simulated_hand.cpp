#include "app/play/simulated_hand.h"

#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace tractus::play {

struct SimulatedHand::Shared {
    std::shared_ptr<drivers::Log const> log;
    std::function<Timestamp()> now;
    // Clock time at which the recording started; no value before begin().
    std::optional<Timestamp> begun {};

    // Returns the time of the clock for a time in the recording. Only valid after begin().
    Timestamp real_time(Timestamp recorded) const { return *begun + (recorded - log->begin()); }
};

namespace {

drivers::RawReport as_report(drivers::Log const& log, drivers::LogRecord const& record,
                             Timestamp received)
{
    auto const bytes = log.report(record);
    drivers::RawReport report { .received = received };
    report.size = std::min(bytes.size(), report.storage.size());
    std::copy_n(bytes.begin(), report.size, report.storage.begin());
    return report;
}

// Source that returns a device's recorded reports as soon as they are due.
class HandSource : public drivers::ReportSource {
public:
    HandSource(std::shared_ptr<SimulatedHand::Shared> shared, std::size_t device)
        : shared_(std::move(shared))
        , device_(device)
    {
    }

    drivers::DeviceInfo const& info() const override { return log().devices[device_]; }

    Result<std::optional<drivers::RawReport>> read(Duration) override
    {
        auto const& records = log().records;
        while (next_ < records.size() && records[next_].device != device_)
            ++next_;
        if (!shared_->begun || next_ == records.size())
            return rest();
        auto const due = shared_->real_time(records[next_].time);
        if (due > shared_->now())
            return std::optional<drivers::RawReport>();
        return as_report(log(), records[next_++], due);
    }

protected:
    // Returns the report to send before the recording begins or after it ends, if there is one.
    virtual std::optional<drivers::RawReport> rest() { return std::nullopt; }

    drivers::Log const& log() const { return *shared_->log; }
    SimulatedHand::Shared const& shared() const { return *shared_; }
    // When rest() is called: true after the recording, false before it.
    bool is_over() const { return shared_->begun.has_value(); }

private:
    std::shared_ptr<SimulatedHand::Shared> shared_;
    std::size_t device_;
    std::size_t next_ = 0; // Index of the next record in the log.
};

// Source of a height sensor that also sends before and after the recording. It repeats the
// recording's first or last reading, alternating with another reading near it, as a sensor without
// noise would be diagnosed as broken.
class HeightSource final : public HandSource {
public:
    HeightSource(std::shared_ptr<SimulatedHand::Shared> shared, std::size_t device)
        : HandSource(std::move(shared), device)
    {
        std::vector<drivers::LogRecord> own;
        for (auto const& record : log().records)
            if (record.device == device && record.size > 0)
                own.push_back(record);
        first_ = two_readings(own);
        std::reverse(own.begin(), own.end());
        last_ = two_readings(own);
    }

private:
    static constexpr Duration kPeriod = std::chrono::milliseconds(5);
    // After a stall of the program, readings are made up for at most this time.
    static constexpr Duration kLongestCatchUp = std::chrono::seconds(1);

    using Readings = std::array<std::optional<drivers::LogRecord>, 2>;

    Readings two_readings(std::span<drivers::LogRecord const> records) const
    {
        if (records.empty())
            return {};
        auto const bytes = log().report(records.front());
        auto const other
            = std::find_if(records.begin(), records.end(), [&](drivers::LogRecord const& record) {
                  auto const others = log().report(record);
                  return !std::equal(bytes.begin(), bytes.end(), others.begin(), others.end());
              });
        return { records.front(), other == records.end() ? records.front() : *other };
    }

    std::optional<drivers::RawReport> rest() override
    {
        auto const now = shared().now();
        auto const begin = is_over() ? shared().real_time(log().end()) : now;
        if (std::exchange(rests_after_, is_over()) != is_over())
            due_.reset();
        if (!due_)
            due_ = begin + kPeriod;
        due_ = std::max(*due_, now - kLongestCatchUp);
        auto const& readings = is_over() ? last_ : first_;
        if (*due_ > now || !readings[0])
            return std::nullopt;
        is_second_ = !is_second_;
        auto const report = as_report(log(), *readings[is_second_ ? 1 : 0], *due_);
        *due_ += kPeriod;
        return report;
    }

    Readings first_ {};
    Readings last_ {};
    bool rests_after_ = false; // True if the current readings are those after the recording.
    bool is_second_ = false;
    std::optional<Timestamp> due_ {}; // Time of the next reading.
};

} // namespace

SimulatedHand::SimulatedHand(std::shared_ptr<drivers::Log const> log,
                             std::function<Timestamp()> now)
    : shared_(std::make_shared<Shared>(Shared { std::move(log), std::move(now) }))
{
    CHECK(shared_->log && !shared_->log->rest && shared_->now);
}

std::vector<std::unique_ptr<drivers::ReportSource>> SimulatedHand::open_sources() const
{
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    for (std::size_t i = 0; i < shared_->log->devices.size(); ++i)
        if (drivers::make_height_decoder(shared_->log->devices[i]))
            sources.push_back(std::make_unique<HeightSource>(shared_, i));
        else
            sources.push_back(std::make_unique<HandSource>(shared_, i));
    return sources;
}

void SimulatedHand::begin()
{
    if (!shared_->begun)
        shared_->begun = shared_->now();
}

bool SimulatedHand::is_over() const
{
    return shared_->begun && shared_->now() > shared_->real_time(shared_->log->end());
}

std::vector<drivers::LogTool> SimulatedHand::take_tools()
{
    std::vector<drivers::LogTool> tools;
    if (!shared_->begun)
        return tools;
    auto const& all = shared_->log->tools;
    for (; next_tool_ < all.size(); ++next_tool_) {
        auto tool = all[next_tool_];
        tool.time = shared_->real_time(tool.time);
        if (tool.time > shared_->now())
            break;
        tools.push_back(std::move(tool));
    }
    return tools;
}

} // namespace tractus::play
