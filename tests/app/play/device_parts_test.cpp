#include "app/play/device_parts.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace tractus::play {
namespace {

// The reports that a test has sent to devices, in order, as "DEVICE:FIRST BYTE".
using Sent = std::vector<std::string>;

// A device that records the reports instead of sending them to the kernel.
class FakeDevice final : public sim::KernelDevice {
public:
    FakeDevice(std::string name, Sent& sent)
        : name_(std::move(name))
        , sent_(sent)
    {
    }

    void add_files_to(std::vector<pollfd>&) const override { }
    Result<void> serve() override
    {
        if (serves_until_read > 0)
            --serves_until_read;
        return {};
    }
    Result<void> send(std::span<std::byte const> report) override
    {
        if (is_broken)
            return fail(Fault::User, "the kernel refuses it");
        sent_.push_back(name_ + ":" + std::to_string(std::to_integer<int>(report[0])));
        if (on_send)
            on_send();
        return {};
    }
    bool is_read() const override { return serves_until_read == 0; }
    bool detects_readers_by_reports() const override { return false; }
    std::uint64_t lost_count() const override { return 0; }
    std::size_t waiting_count() const override { return 0; }

    int serves_until_read = 0;
    bool is_broken = false;
    std::function<void()> on_send {};

private:
    std::string name_;
    Sent& sent_;
};

// Returns a report whose first byte is `byte`, received at `time_ms`.
drivers::RawReport report(int time_ms, int byte)
{
    drivers::RawReport result { .received = Timestamp(std::chrono::milliseconds(time_ms)),
                                .size = 1 };
    result.storage[0] = static_cast<std::byte>(byte);
    return result;
}

class DeviceParts : public testing::Test {
protected:
    FakeDevice& add(std::string name, std::vector<drivers::RawReport> reports)
    {
        auto& device = *devices.emplace_back(std::make_unique<FakeDevice>(std::move(name), sent));
        parts.push_back(
            std::make_unique<ReportPart>(device, [reports = std::move(reports)]() -> NextReport {
                return [reports, next = std::size_t { 0 }]() mutable {
                    return Result<std::optional<drivers::RawReport>>(
                        next < reports.size() ? std::optional(reports[next++]) : std::nullopt);
                };
            }));
        play.devices.push_back(&device);
        play.parts.push_back(parts.back().get());
        return device;
    }

    Sent sent;
    std::vector<std::unique_ptr<FakeDevice>> devices;
    std::vector<std::unique_ptr<ReportPart>> parts;
    PlaybackSet play;
    std::atomic<bool> stop = false;
};

TEST_F(DeviceParts, SendEveryDevicesReports)
{
    add("pen", { report(0, 10), report(1, 12) });
    add("height", { report(1, 11) });
    add("silent", {});
    auto const played = play_parts(play, stop);
    ASSERT_TRUE(played) << played.error().message;
    std::sort(sent.begin(), sent.end());
    EXPECT_EQ(sent, (Sent { "height:11", "pen:10", "pen:12" }));
}

TEST_F(DeviceParts, WaitUntilEachDeviceIsRead)
{
    add("pen", { report(0, 10) });
    auto& height = add("height", { report(0, 11) });
    height.serves_until_read = 3;
    play.on_begin = [&] { EXPECT_TRUE(sent.empty()); };
    EXPECT_TRUE(play_parts(play, stop));
    EXPECT_EQ(height.serves_until_read, 0);
    EXPECT_EQ(sent.size(), 2u);
}

TEST_F(DeviceParts, BeginAnewUntilTheyAreAskedToStop)
{
    auto& pen = add("pen", { report(0, 10), report(1, 12) });
    pen.on_send = [&] { stop = sent.size() >= 5; };
    play.then = PlaybackSet::Then::Repeat;
    EXPECT_TRUE(play_parts(play, stop));
    sent.resize(5); // Another report may have been sent at the same time.
    EXPECT_EQ(sent, (Sent { "pen:10", "pen:12", "pen:10", "pen:12", "pen:10" }));
}

TEST_F(DeviceParts, EndWhenTheyAreAskedTo)
{
    add("pen", { report(0, 10) }).serves_until_read = 1'000'000;
    stop = true;
    play.then = PlaybackSet::Then::Stay;
    EXPECT_TRUE(play_parts(play, stop));
    EXPECT_EQ(sent, Sent {});
}

TEST_F(DeviceParts, EndWithTheErrorOfADevice)
{
    add("pen", { report(0, 10) }).is_broken = true;
    auto const played = play_parts(play, stop);
    ASSERT_FALSE(played);
    EXPECT_EQ(played.error().message, "the kernel refuses it");
}

} // namespace
} // namespace tractus::play
