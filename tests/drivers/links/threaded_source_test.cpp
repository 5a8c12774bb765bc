#include "drivers/links/threaded_source.h"

#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

// Time limit of a read, long enough for any machine; a read returns as soon as there is a report.
constexpr Duration kPatience = 30s;

// A source that gives `count` reports, numbered in their first two bytes, and then nothing or an
// error.
class Script final : public ReportSource {
public:
    enum class End { Silence, Error };

    Script(int count, End end, std::atomic<int>* destroyed = nullptr)
        : count_(count)
        , end_(end)
        , destroyed_(destroyed)
    {
        info_.name = "Script";
    }

    ~Script() override
    {
        if (destroyed_)
            ++*destroyed_;
    }

    DeviceInfo const& info() const override { return info_; }

    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        if (sent_ < count_) {
            RawReport report { .received = timestamp_ns(sent_), .size = 2 };
            report.storage[0] = static_cast<std::byte>(sent_ & 0xFF);
            report.storage[1] = static_cast<std::byte>(sent_ >> 8);
            ++sent_;
            return std::optional(report);
        }
        if (end_ == End::Error)
            return fail(Fault::Device, "lost Script");
        std::this_thread::sleep_for(timeout);
        return std::optional<RawReport>();
    }

private:
    DeviceInfo info_;
    int count_;
    End end_;
    std::atomic<int>* destroyed_;
    int sent_ = 0;
};

std::unique_ptr<ThreadedSource> start(int count, Script::End end)
{
    auto source = ThreadedSource::start(std::make_unique<Script>(count, end));
    EXPECT_TRUE(source) << source.error().message;
    return *std::move(source);
}

TEST(ThreadedSource, HandsOutEveryReportInOrder)
{
    auto const source = start(1000, Script::End::Silence);
    EXPECT_EQ(source->info().name, "Script");
    for (int i = 0; i < 1000; ++i) {
        auto const report = source->read(kPatience);
        ASSERT_TRUE(report && *report);
        EXPECT_EQ((*report)->received, timestamp_ns(i));
        EXPECT_EQ(std::to_integer<int>((*report)->bytes()[0]), i & 0xFF);
    }
    EXPECT_EQ(source->lost_count(), 0u);
}

TEST(ThreadedSource, HasNothingWhenNothingCame)
{
    auto const source = start(0, Script::End::Silence);
    auto const report = source->read(1ms);
    ASSERT_TRUE(report);
    EXPECT_EQ(*report, std::nullopt);
}

TEST(ThreadedSource, TellsTheSourcesErrorAfterItsLastReport)
{
    auto const source = start(3, Script::End::Error);
    for (int i = 0; i < 3; ++i) {
        auto const report = source->read(kPatience);
        ASSERT_TRUE(report && *report);
    }
    auto const end = source->read(kPatience);
    ASSERT_FALSE(end);
    EXPECT_EQ(end.error().message, "lost Script");
    EXPECT_FALSE(source->read(kPatience)); // The error is repeated.
}

TEST(ThreadedSource, CountsWhatTheRingCouldNotHold)
{
    constexpr int kSent = static_cast<int>(ThreadedSource::kRingReports) + 500;
    auto const source = start(kSent, Script::End::Error);
    while (source->lost_count() < 500)
        std::this_thread::sleep_for(1ms);
    std::uint64_t received = 0;
    for (;;) {
        auto const report = source->read(kPatience);
        if (!report)
            break;
        EXPECT_EQ((*report)->received,
                  // When the ring is full, the oldest reports are kept.
                  timestamp_ns(static_cast<std::int64_t>(received)));
        ++received;
    }
    EXPECT_EQ(received + source->lost_count(), static_cast<std::uint64_t>(kSent));
}

TEST(ThreadedSource, StopsAndDestroysItsSource)
{
    std::atomic<int> destroyed = 0;
    {
        auto const source
            = ThreadedSource::start(std::make_unique<Script>(10, Script::End::Silence, &destroyed));
        ASSERT_TRUE(source);
        EXPECT_EQ(destroyed, 0);
    }
    EXPECT_EQ(destroyed, 1);
}

} // namespace
} // namespace tractus::drivers
