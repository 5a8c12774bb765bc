#include "app/device_playback.h"

#include <gtest/gtest.h>
#include <string_view>

namespace tractus {
namespace {

// What the devices of a test were sent, in order: "DEVICE:FIRST BYTE".
using Sent = std::vector<std::string>;

// A device whose kernel is the test.
class FakeDevice final : public KernelDevice {
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
        return {};
    }
    bool is_read() const override { return serves_until_read == 0; }
    bool tells_readers_by_reports() const override { return false; }
    std::uint64_t lost_count() const override { return lost; }
    std::size_t waiting_count() const override { return 0; }

    int serves_until_read = 0;
    bool is_broken = false;
    std::uint64_t lost = 0;

private:
    std::string name_;
    Sent& sent_;
};

constexpr std::string_view kTwoDevices = "D: 0\nR: 1 00\nN: pen\nI: 3 0001 0001\n"
                                         "D: 1\nR: 1 00\nN: height\nI: 3 0001 0002\n"
                                         "D: 0\nE: 000001.000000 1 0a\n"
                                         "D: 1\nE: 000001.001000 1 0b\n"
                                         "D: 0\nE: 000001.002000 1 0c\n";

class DevicePlayback : public testing::Test {
protected:
    FakeDevice& add(std::size_t log_device)
    {
        auto device = std::make_unique<FakeDevice>(log_device == 0 ? "pen" : "height", sent);
        auto& fake = *device;
        played.push_back({ log_device, std::move(device) });
        return fake;
    }

    Result<PlaybackCounts> play(PlaybackOptions const& options = {})
    {
        return play_devices(log, played, options, stop);
    }

    Log const log = parse_log(kTwoDevices, "two").value();
    Sent sent;
    std::vector<PlayedDevice> played;
    std::atomic<bool> stop = false;
};

TEST_F(DevicePlayback, SendsEveryDevicesReportsInTheLogsOrder)
{
    add(0);
    add(1);
    auto const counts = play();
    ASSERT_TRUE(counts) << counts.error().message;
    EXPECT_EQ(sent, (Sent { "pen:10", "height:11", "pen:12" }));
    EXPECT_EQ(counts->reports, 3u);
    EXPECT_EQ(counts->lost, 0u);
}

TEST_F(DevicePlayback, SendsTheSameAtOnceAndAtAnyRate)
{
    add(0);
    EXPECT_TRUE(play({ .at_once = true }));
    EXPECT_TRUE(play({ .rate_hz = 1000 }));
    EXPECT_EQ(sent, (Sent { "pen:10", "pen:12", "pen:10", "pen:12" }));
}

TEST_F(DevicePlayback, LeavesOutWhatIsNotPlayed)
{
    add(1);
    EXPECT_EQ(play().value().reports, 1u);
    EXPECT_EQ(sent, Sent { "height:11" });
}

TEST_F(DevicePlayback, WaitsUntilEachDeviceIsRead)
{
    add(0);
    auto& height = add(1);
    height.serves_until_read = 3;
    EXPECT_TRUE(play());
    EXPECT_EQ(height.serves_until_read, 0);
    EXPECT_EQ(sent.size(), 3u);
}

TEST_F(DevicePlayback, CountsWhatTheDevicesLost)
{
    add(0).lost = 1;
    EXPECT_EQ(play().value().lost, 1u);
}

TEST_F(DevicePlayback, EndsWhenItIsAskedTo)
{
    add(0).serves_until_read = 1'000'000;
    stop = true;
    EXPECT_EQ(play({ .stay = true }).value().reports, 0u);
    EXPECT_EQ(sent, Sent {});
}

TEST_F(DevicePlayback, EndsWithTheErrorOfADevice)
{
    add(0).is_broken = true;
    auto const counts = play();
    ASSERT_FALSE(counts);
    EXPECT_EQ(counts.error().message, "the kernel refuses it");
}

} // namespace
} // namespace tractus
