#include "drivers/reconnecting_source.h"

#include "drivers/links/threaded_source.h"
#include "tests/drivers/devices.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <utility>

namespace tractus::drivers {
namespace {

// A fake bus: the devices plugged in, and counts of what was done with them.
struct Bus {
    std::vector<DeviceInfo> plugged {};
    int opened = 0;
    int open_now = 0;
    bool may_open = true;
    std::uint8_t next_byte = 1;
    Timestamp now = timestamp_ns(1'000'000'000);
    Duration slept {};
};

// A device that gives one report per read while it is plugged in at the location where it was
// opened.
class FakeDevice final : public ReportSource {
public:
    FakeDevice(Bus& bus, DeviceInfo info)
        : bus_(bus)
        , info_(std::move(info))
    {
        ++bus_.opened;
        ++bus_.open_now;
    }
    ~FakeDevice() override { --bus_.open_now; }

    DeviceInfo const& info() const override { return info_; }

    Result<std::optional<RawReport>> read(Duration) override
    {
        for (auto const& plugged : bus_.plugged)
            if (plugged.location == info_.location) {
                RawReport report { .received = bus_.now, .size = 1 };
                report.storage[0] = std::byte { bus_.next_byte++ };
                return std::optional(report);
            }
        return fail(Fault::Device, "lost it");
    }

private:
    Bus& bus_;
    DeviceInfo info_;
};

Reconnection reconnection(Bus& bus)
{
    return { .list = [&bus] { return bus.plugged; },
             .open = [&bus](DeviceInfo info) -> Result<std::unique_ptr<ReportSource>> {
                 if (!bus.may_open)
                     return fail(Fault::User, "permission denied");
                 return std::make_unique<FakeDevice>(bus, std::move(info));
             },
             .now = [&bus] { return bus.now; },
             .slept = [&bus] { return bus.slept; },
             .retry_every = Duration(0) };
}

DeviceInfo pen_at(std::string location, std::string path = "usb-1/input0")
{
    auto info = simple_pen();
    info.location = std::move(location);
    info.physical_path = std::move(path);
    return info;
}

// Reads several times and returns a letter for each: 'r' a report, 'g' the device has gone, '-'
// nothing.
std::string reads(ReportSource& source, int count)
{
    std::string result;
    for (int i = 0; i < count; ++i) {
        auto const report = source.read(Duration(0));
        EXPECT_TRUE(report);
        result += !report || !*report ? '-' : (*report)->size == 0 ? 'g' : 'r';
    }
    return result;
}

TEST(ReconnectingSource, SaysOnceThatTheDeviceHasGone)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    EXPECT_EQ(reads(*source, 2), "rr");
    bus.plugged.clear();
    bus.now = timestamp_ns(2'000'000'000);
    auto const gone = source->read(Duration(0));
    ASSERT_TRUE(gone && *gone);
    EXPECT_EQ((*gone)->size, 0u);
    EXPECT_EQ((*gone)->received, bus.now);
    EXPECT_FALSE(source->is_connected());
    EXPECT_EQ(reads(*source, 3), "---");
    EXPECT_EQ(bus.open_now, 0);
}

TEST(ReconnectingSource, FindsTheDeviceUnderAnotherName)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 2), "g-");
    auto other = simple_height_sensor();
    other.location = "/dev/hidraw0";
    bus.plugged = { other, pen_at("/dev/hidraw7") };
    EXPECT_EQ(reads(*source, 3), "-rr");
    EXPECT_TRUE(source->is_connected());
    EXPECT_EQ(source->info().location, "/dev/hidraw0");
    EXPECT_EQ(bus.open_now, 1);
}

TEST(ReconnectingSource, KeepsWhatItsUserWantsOfTheDevice)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto means = reconnection(bus);
    std::vector<std::string> settings;
    means.open = [&settings, open = means.open](DeviceInfo info) {
        settings.push_back(info.settings);
        return open(std::move(info));
    };
    auto wanted = bus.plugged[0];
    wanted.settings = "GP2";
    auto const source = ReconnectingSource::open(wanted, means).value();
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 2), "g-");
    bus.plugged = { pen_at("/dev/hidraw7") };
    EXPECT_EQ(reads(*source, 2), "-r");
    EXPECT_EQ(settings, (std::vector<std::string> { "GP2", "GP2" }));
}

TEST(ReconnectingSource, ComesBackAsOftenAsItGoes)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    for (int i = 1; i <= 10; ++i) {
        bus.plugged.clear();
        EXPECT_EQ(reads(*source, 2), "g-");
        bus.plugged = { pen_at("/dev/hidraw" + std::to_string(i)) };
        EXPECT_EQ(reads(*source, 2), "-r");
    }
    EXPECT_EQ(bus.opened, 11);
    EXPECT_EQ(bus.open_now, 1);
}

TEST(ReconnectingSource, WaitsUntilItMayOpenIt)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 1), "g");
    bus.plugged = { pen_at("/dev/hidraw0") };
    bus.may_open = false;
    EXPECT_EQ(reads(*source, 3), "---");
    bus.may_open = true;
    EXPECT_EQ(reads(*source, 2), "-r");
}

TEST(ReconnectingSource, SaysWhyTheDeviceThatIsBackCannotBeOpened)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 2), "g-");
    EXPECT_EQ(source->refusal(), "");
    bus.plugged = { pen_at("/dev/hidraw1") };
    bus.may_open = false;
    EXPECT_EQ(reads(*source, 1), "-");
    EXPECT_EQ(source->refusal(), ""); // Udev may not have set the permissions yet.
    bus.now += ReconnectingSource::kPatience;
    EXPECT_EQ(reads(*source, 1), "-");
    EXPECT_EQ(source->refusal(), "permission denied");
    bus.may_open = true;
    EXPECT_EQ(reads(*source, 2), "-r");
    EXPECT_EQ(source->refusal(), "");
}

TEST(ReconnectingSource, LooksForItNoOftenerThanAsked)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    int lists = 0;
    auto means = reconnection(bus);
    means.retry_every = std::chrono::milliseconds(300);
    means.list = [&] { return ++lists, std::vector<DeviceInfo> {}; };
    auto const source = ReconnectingSource::open(bus.plugged[0], means).value();
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 100), "g" + std::string(99, '-'));
    EXPECT_EQ(lists, 1);
    bus.now += std::chrono::milliseconds(300);
    reads(*source, 100);
    EXPECT_EQ(lists, 2);
}

// Device events under the test's control.
class FakeEvents final : public DeviceEvents {
public:
    explicit FakeEvents(bool& has_come)
        : has_come_(has_come)
    {
    }
    bool wait(Duration) override { return std::exchange(has_come_, false); }

private:
    bool& has_come_;
};

TEST(ReconnectingSource, LooksForItWhenSomethingHasCome)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    int lists = 0;
    int listeners = 0;
    bool has_come = false;
    auto means = reconnection(bus);
    means.retry_every = std::chrono::milliseconds(300);
    means.list = [&] { return ++lists, bus.plugged; };
    means.events = [&] { return ++listeners, std::make_unique<FakeEvents>(has_come); };
    auto const source = ReconnectingSource::open(bus.plugged[0], means).value();
    EXPECT_EQ(reads(*source, 2), "rr");
    EXPECT_EQ(listeners, 0);
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 3), "g--");
    EXPECT_EQ(listeners, 1);
    EXPECT_EQ(lists, 1) << "it may have come back at once";
    for (int i = 0; i < 10; ++i) {
        bus.now += std::chrono::milliseconds(400);
        EXPECT_EQ(reads(*source, 1), "-");
    }
    EXPECT_EQ(lists, 1) << "nobody has told of anything";
    has_come = true; // The event belongs to another device.
    EXPECT_EQ(reads(*source, 2), "--");
    EXPECT_EQ(lists, 2);
    bus.plugged = { pen_at("/dev/hidraw3") };
    has_come = true;
    EXPECT_EQ(reads(*source, 2), "-r");
}

TEST(ReconnectingSource, LooksForItNowAndThenThoughNobodyTells)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    bool has_come = false;
    auto means = reconnection(bus);
    means.events = [&] { return std::make_unique<FakeEvents>(has_come); };
    auto const source = ReconnectingSource::open(bus.plugged[0], means).value();
    auto const lost = std::exchange(bus.plugged, {});
    EXPECT_EQ(reads(*source, 2), "g-");
    bus.plugged = lost;
    bus.may_open = false;
    bus.now += means.retry_beside_events;
    EXPECT_EQ(reads(*source, 1), "-");
    // No event announces a changed permission, so the source soon tries the device again by itself.
    bus.may_open = true;
    EXPECT_EQ(reads(*source, 2), "-r");
}

TEST(DeviceEvents, OfUdevComeOrDoNot)
{
    auto const events = listen_to_udev();
    if (!std::filesystem::exists("/run/udev/control")) {
        EXPECT_FALSE(events);
        return;
    }
    ASSERT_TRUE(events);
    (void)events->wait(Duration(0)); // Another device may be plugged in meanwhile.
}

TEST(ReconnectingSource, OpensTheDeviceAnewAfterTheMachineSlept)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    EXPECT_EQ(reads(*source, 1), "r");
    bus.slept += std::chrono::minutes(5);
    EXPECT_EQ(reads(*source, 4), "g-rr");
    EXPECT_EQ(bus.opened, 2);
    EXPECT_EQ(bus.open_now, 1);
}

TEST(ReconnectingSource, DoesNotTakeItsTwinForIt)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0", "usb-1/input0"),
                           pen_at("/dev/hidraw1", "usb-2/input0") } };
    auto const means = reconnection(bus);
    auto const first = ReconnectingSource::open(bus.plugged[0], means).value();
    auto const second = ReconnectingSource::open(bus.plugged[1], means).value();
    bus.plugged.erase(bus.plugged.begin());
    EXPECT_EQ(reads(*first, 4), "g---");
    EXPECT_EQ(reads(*second, 2), "rr");
    bus.plugged.push_back(pen_at("/dev/hidraw2", "usb-5/input0"));
    EXPECT_EQ(reads(*first, 2), "-r");
}

TEST(ReconnectingSource, FindsAtItsAddressWhatNoListNames)
{
    auto sensor = simple_height_sensor();
    sensor.location = "gpio:gpiochip0:11,10,9,8:mcp3208:0";
    Bus bus { .plugged = { sensor } };
    auto means = reconnection(bus);
    means.list = [] { return std::vector<DeviceInfo> {}; };
    auto const source = ReconnectingSource::open(sensor, means).value();
    bus.plugged.clear();
    bus.may_open = false;
    EXPECT_EQ(reads(*source, 2), "g-");
    bus.plugged = { sensor };
    bus.may_open = true;
    EXPECT_EQ(reads(*source, 2), "-r");
}

TEST(ReconnectingSource, FindsATabletReadPastTheKernelInAnotherSocket)
{
    auto const tablet = [](std::string location, std::string path) {
        auto info = pen_at(std::move(location), std::move(path));
        if (info.location.starts_with("libusb:"))
            // The descriptor is not known before the device is opened.
            info.report_descriptor.clear();
        return info;
    };
    Bus bus { .plugged = { tablet("libusb:1-2:0", "usb-1-2/input0") } };
    auto const source = ReconnectingSource::open(bus.plugged[0], reconnection(bus)).value();
    bus.plugged.clear();
    EXPECT_EQ(reads(*source, 2), "g-");
    // The device's hidraw node appears before its libusb address.
    bus.plugged = { tablet("/dev/hidraw0", "usb-0000:00:14.0-4.1/input0") };
    EXPECT_EQ(reads(*source, 2), "--");
    bus.plugged.push_back(tablet("libusb:3-4.1:0", "usb-3-4.1/input0"));
    EXPECT_EQ(reads(*source, 2), "-r");
    EXPECT_EQ(bus.open_now, 1);
}

TEST(ReconnectingSource, IsReadOnAThread)
{
    Bus bus { .plugged = { pen_at("/dev/hidraw0") } };
    bus.plugged[0].location = "/dev/hidraw1"; // The device has gone before it is read.
    auto source = ReconnectingSource::open(pen_at("/dev/hidraw0"), reconnection(bus)).value();
    auto const threaded = ThreadedSource::start(std::move(source)).value();
    std::string seen;
    while (seen.size() < 3)
        if (auto const report = threaded->read(std::chrono::seconds(10)).value())
            seen += report->size == 0 ? 'g' : 'r';
    EXPECT_EQ(seen, "grr");
}

TEST(ReconnectingSource, FailsIfTheDeviceIsNotThereAtFirst)
{
    Bus bus { .may_open = false };
    auto const source = ReconnectingSource::open(pen_at("/dev/hidraw0"), reconnection(bus));
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().message, "permission denied");
}

TEST(FindAgain, TellsEqualTabletsApartByTheirPlaceAndSerialNumber)
{
    auto const lost = pen_at("/dev/hidraw0", "usb-1/input0");
    auto const here = pen_at("/dev/hidraw4", "usb-1/input0");
    auto const there = pen_at("/dev/hidraw5", "usb-2/input0");
    EXPECT_EQ(find_again(lost, { there, here }), 1u);
    EXPECT_EQ(find_again(lost, { there }), 0u);
    EXPECT_EQ(find_again(lost, { there, pen_at("/dev/hidraw6", "usb-3/input0") }), std::nullopt);
    auto other_serial = here;
    other_serial.serial_number = "B";
    EXPECT_EQ(find_again(lost, { other_serial }), std::nullopt);
    auto other_node = here;
    other_node.report_descriptor = bytes("05 01 09 02 a1 01 c0");
    EXPECT_EQ(find_again(lost, { other_node }), std::nullopt);
}

} // namespace
} // namespace tractus::drivers
