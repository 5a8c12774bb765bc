#include "drivers/links/hid_sysfs.h"

#include "drivers/links/hid_source.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::drivers {
namespace {

namespace fs = std::filesystem;

// Fixture with a folder that imitates sysfs with one tablet of two interfaces on port 2 of bus 1,
// and a device without a bus.
class HidSysfs : public testing::Test {
protected:
    HidSysfs()
        : root_(fs::temp_directory_path() / ("tractus_sysfs_" + std::to_string(::getpid())))
    {
        auto const usb = root_ / "devices" / "usb1" / "1-2";
        write(usb / "busnum", "1");
        write(usb / "manufacturer", "HUION");
        write(usb / "product", "Huion Tablet");
        write(usb / "serial", "0815");
        add_hidraw("hidraw0", usb / "1-2:1.0" / "0003:256C:006D.0001", "hid-generic");
        write(usb / "1-2:1.0" / "bInterfaceNumber", "00");
        add_hidraw("hidraw1", usb / "1-2:1.1" / "0003:256C:006D.0002", "uclogic");
        write(usb / "1-2:1.1" / "bInterfaceNumber", "01");
        add_hidraw("hidraw2", root_ / "devices" / "virtual" / "uhid" / "0003:1209:0002.0003", "");
    }
    ~HidSysfs() override { fs::remove_all(root_); }

    fs::path class_folder() const { return root_ / "class" / "hidraw"; }

private:
    static void write(fs::path const& file, std::string const& text)
    {
        fs::create_directories(file.parent_path());
        std::ofstream(file) << text << '\n';
    }
    void add_hidraw(std::string const& name, fs::path const& device, std::string const& driver)
    {
        write(device / "uevent", "HID_ID=0003:0000256C:0000006D\nHID_NAME=HUION Huion Tablet");
        fs::create_directories(class_folder() / name);
        fs::create_directory_symlink(device, class_folder() / name / "device");
        if (driver.empty())
            return;
        fs::create_directories(root_ / "drivers" / driver);
        fs::create_directory_symlink(root_ / "drivers" / driver, device / "driver");
    }

    fs::path root_;
};

TEST_F(HidSysfs, TellsTheUsbDeviceOfANode)
{
    auto const usb = find_usb_parent(class_folder() / "hidraw1");
    ASSERT_TRUE(usb);
    EXPECT_EQ(usb->address, "1-2");
    EXPECT_EQ(usb->interface_number, 1);
    EXPECT_EQ(usb->manufacturer, "HUION");
    EXPECT_EQ(usb->product, "Huion Tablet");
    EXPECT_EQ(usb->serial_number, "0815");
}

TEST_F(HidSysfs, TellsNoUsbDeviceWhereThereIsNone)
{
    EXPECT_FALSE(find_usb_parent(class_folder() / "hidraw2"));
    EXPECT_FALSE(find_usb_parent(class_folder() / "hidraw9"));
}

TEST_F(HidSysfs, TellsTheKernelsDriver)
{
    EXPECT_EQ(bound_driver(class_folder() / "hidraw1"), "uclogic");
    EXPECT_EQ(bound_driver(class_folder() / "hidraw2"), "");
}

TEST_F(HidSysfs, IsReadWhenDevicesAreListed)
{
    auto const devices = enumerate_hid(class_folder());
    ASSERT_EQ(devices.size(), 3u);
    EXPECT_EQ(devices[1].manufacturer, "HUION");
    EXPECT_EQ(devices[1].serial_number, "0815");
    EXPECT_EQ(devices[1].interface_number, 1);
    EXPECT_EQ(devices[2].interface_number, -1);
}

} // namespace
} // namespace tractus::drivers
