#include "drivers/links/hid_source.h"

#include "drivers/device_kind.h"
#include "drivers/links/hid_back_end.h"
#include "drivers/links/hid_link.h"
#include "engine/base/file.h"
#include "tests/drivers/devices.h"

#include <cerrno>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::drivers {
namespace {

namespace fs = std::filesystem;

// Fixture with a folder that imitates /sys/class/hidraw.
class SysfsTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    void plug_in(std::string const& node, std::string const& event,
                 std::vector<std::byte> const& descriptor)
    {
        auto const device = folder_ / node / "device";
        fs::create_directories(device);
        ASSERT_TRUE(write_file(device / "uevent", event));
        ASSERT_TRUE(write_file(
            device / "report_descriptor",
            std::string_view(reinterpret_cast<char const*>(descriptor.data()), descriptor.size())));
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus-hidraw-" + std::to_string(::getpid()));
};

TEST_F(SysfsTest, DescribesEveryNode)
{
    plug_in("hidraw10", "DRIVER=hid-generic\nHID_ID=0018:000004F3:00002817\nHID_NAME=ELAN\n", {});
    plug_in("hidraw9",
            "DRIVER=wacom\nHID_ID=0003:00001209:00000002\nHID_NAME=Simple Pen\n"
            "HID_PHYS=usb-0000:00:14.0-1/input0\nHID_UNIQ=\nMODALIAS=hid:b0003\n",
            simple_pen().report_descriptor);
    auto const devices = enumerate_hid(folder_);
    ASSERT_EQ(devices.size(), 2u);
    auto const& pen = devices[0]; // Node 9 comes before node 10.
    EXPECT_EQ(pen.location, "/dev/hidraw9");
    EXPECT_EQ(pen.name, "Simple Pen");
    EXPECT_EQ(pen.physical_path, "usb-0000:00:14.0-1/input0");
    EXPECT_EQ(pen.bus, 3);
    EXPECT_EQ(pen.vendor_id, 0x1209);
    EXPECT_EQ(pen.product_id, 0x0002);
    EXPECT_EQ(pen.report_descriptor, simple_pen().report_descriptor);
    EXPECT_EQ(devices[1].bus, 0x18);
    EXPECT_EQ(devices[1].vendor_id, 0x04f3);
}

TEST_F(SysfsTest, ListsADeviceWhoseFilesAreMissing)
{
    fs::create_directories(folder_ / "hidraw0");
    auto const devices = enumerate_hid(folder_);
    ASSERT_EQ(devices.size(), 1u);
    EXPECT_EQ(devices[0].location, "/dev/hidraw0");
    EXPECT_TRUE(devices[0].report_descriptor.empty());
    EXPECT_EQ(describe_device(devices[0]).kind, DeviceKind::Other);
}

TEST(HidSource, FindsNothingWhereThereIsNoHidraw)
{
    EXPECT_TRUE(enumerate_hid("/nowhere").empty());
}

TEST(HidSource, SaysThatADeviceIsGone)
{
    auto const source = open_hid({ .name = "Simple Pen", .location = "/dev/hidraw-nowhere" });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
    EXPECT_EQ(source.error().message,
              "cannot open Simple Pen at /dev/hidraw-nowhere: there is no such device (was it "
              "unplugged?)");
}

TEST(HidSource, NamesTheRuleThatPermits)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may read everything";
    auto const source = open_hid({ .name = "Simple Pen", .location = "/etc/shadow" });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().message,
              "cannot open Simple Pen at /etc/shadow: permission denied (is "
              "drivers/70-tractus.rules in /etc/udev/rules.d?)");
}

TEST(HidSource, NamesTheReasonForWhichANodeCannotBeOpened)
{
    DeviceInfo const info { .name = "Simple Pen", .location = "/dev/hidraw3" };
    EXPECT_EQ(cannot_open_hidraw(info, EACCES),
              "cannot open Simple Pen at /dev/hidraw3: permission denied (is "
              "drivers/70-tractus.rules in /etc/udev/rules.d?)");
    EXPECT_EQ(cannot_open_hidraw(info, EBUSY),
              "cannot open Simple Pen at /dev/hidraw3: it is busy (another program keeps it for "
              "itself: close that, and try again)");
    EXPECT_EQ(
        cannot_open_hidraw(info, ENODEV),
        "cannot open Simple Pen at /dev/hidraw3: there is no such device (was it unplugged?)");
}

TEST(HidSource, CountsReportsThatAreTooLong)
{
    // A back end whose reports fill the reader's buffer, one byte more than a report may have.
    static constexpr HidBackEnd kLongReports {
        .write = nullptr,
        .read_timeout = [](hid_device_*, unsigned char*, std::size_t size,
                           int) { return static_cast<int>(size); },
        .close = [](hid_device_*) {},
        .error = nullptr,
    };
    char device = 0;
    HidHandle handle(reinterpret_cast<hid_device_*>(&device), kLongReports.close);
    auto const source = make_hid_source(
        simple_pen(), make_hid_link(kLongReports, std::move(handle), simple_pen()));
    EXPECT_EQ(source->oversized_count(), 0u);
    for (int i = 0; i < 2; ++i) {
        auto const report = source->read(Duration(0));
        ASSERT_TRUE(report);
        EXPECT_FALSE(*report);
    }
    EXPECT_EQ(source->oversized_count(), 2u);
}

TEST(DeviceKind, TellsPensFromSensorsFromOthers)
{
    auto const pen = describe_device(simple_pen());
    EXPECT_EQ(pen.kind, DeviceKind::Pen);
    EXPECT_EQ(pen.text,
              "pen tablet, 200.0 x 100.0 mm, pressure to 2047, tilt, eraser, 2 barrel buttons");
    auto const height = describe_device(simple_height_sensor());
    EXPECT_EQ(height.kind, DeviceKind::Height);
    EXPECT_EQ(height.text, "height sensor, 0 to 4095");
    EXPECT_EQ(describe_device({ .name = "Empty" }).text,
              "Empty (0000:0000): the report descriptor is empty");
}

} // namespace
} // namespace tractus::drivers
