#include "app/diagnosis/system_facts.h"

#include "drivers/library_versions.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::diagnosis {
namespace {

namespace fs = std::filesystem;

// Fixture with the system files of a machine: a Wacom tablet on USB port 1-2 with its hidraw node,
// and the tablet's second interface, which has no driver.
class SystemFactsTest : public testing::Test {
protected:
    void SetUp() override
    {
        write(usb_ + "1-2/idVendor", "056a\n");
        write(usb_ + "1-2/idProduct", "037a\n");
        write(usb_ + "1-2/product", "CTL-472\n");
        write(usb_ + "1-2/1-2:1.0/bInterfaceNumber", "00\n");
        write(usb_ + "1-2/1-2:1.0/bInterfaceClass", "03\n");
        write(usb_ + "1-2/1-2:1.0/ep_81/interval", "8ms\n");
        write(usb_ + "1-2/1-2:1.1/bInterfaceNumber", "01\n");
        write(usb_ + "1-2/1-2:1.1/bInterfaceClass", "03\n");
        write(usb_ + "usb1/idVendor", "1d6b\n");
        link("../../drivers/usbhid", usb_ + "1-2/1-2:1.0/driver");
        std::string const hid = usb_ + "1-2/1-2:1.0/0003:056A:037A.0001/";
        write(hid + "uevent", "HID_ID=0003:0000056A:0000037A\nHID_NAME=Wacom CTL-472\n");
        write(hid + "hidraw/hidraw0/dev", "");
        link("../../drivers/wacom", hid + "driver");
        fs::create_directories(root_ / "sys/class/hidraw/hidraw0");
        link((root_ / hid).string(), "sys/class/hidraw/hidraw0/device");
    }
    void TearDown() override { fs::remove_all(root_); }

    void write(std::string const& path, std::string const& text) const
    {
        fs::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }
    void link(std::string const& to, std::string const& path) const
    {
        fs::create_symlink(to, root_ / path);
    }

    fs::path root_ = fs::temp_directory_path() / ("tractus_facts_" + std::to_string(::getpid()));
    std::string usb_ = "sys/bus/usb/devices/";
};

TEST_F(SystemFactsTest, KnowsDriversNodesAndPollRate)
{
    write("dev/hidraw0", "");
    auto const facts = gather_system_facts(root_);
    ASSERT_EQ(facts.devices.size(), 1u);
    EXPECT_EQ(facts.devices[0].info.location, "/dev/hidraw0");
    EXPECT_EQ(facts.devices[0].driver, "wacom");
    EXPECT_NE(facts.devices[0].tablet.find("CTL-472"), std::string::npos);
    EXPECT_FALSE(facts.devices[0].family.empty());
    EXPECT_EQ(facts.devices[0].poll_hz, 125);
    EXPECT_EQ(facts.devices[0].open_error, 0);
    ASSERT_EQ(facts.usb.size(), 1u);
    EXPECT_EQ(facts.usb[0].port, "1-2");
    EXPECT_EQ(facts.usb[0].product_id, 0x037a);
    ASSERT_EQ(facts.usb[0].interfaces.size(), 2u);
    EXPECT_EQ(facts.usb[0].interfaces[0].driver, "usbhid");
    EXPECT_TRUE(facts.usb[0].interfaces[0].has_node);
    EXPECT_EQ(facts.usb[0].interfaces[1].driver, "");
    EXPECT_FALSE(facts.usb[0].interfaces[1].has_node);
    EXPECT_TRUE(facts.has_hidraw);
}

TEST_F(SystemFactsTest, SaysWhyANodeCannotBeOpened)
{
    EXPECT_EQ(gather_system_facts(root_).devices.at(0).open_error, ENOENT);
}

TEST_F(SystemFactsTest, FindsWhatADriverKeepsForItself)
{
    std::string const hid = "sys/bus/hid/devices/";
    write(hid + "0003:056A:037A.0001/hidraw/hidraw0/dev", "");
    write(hid + "0003:04D8:00DD.0002/uevent", "");
    link("../../drivers/mcp2221", hid + "0003:04D8:00DD.0002/driver");
    auto const facts = gather_system_facts(root_);
    ASSERT_EQ(facts.hidden.size(), 1u);
    EXPECT_EQ(facts.hidden[0].name, "0003:04D8:00DD.0002");
    EXPECT_EQ(facts.hidden[0].vendor_id, 0x04d8);
    EXPECT_EQ(facts.hidden[0].product_id, 0x00dd);
    EXPECT_EQ(facts.hidden[0].driver, "mcp2221");
}

TEST_F(SystemFactsTest, LooksForOurRules)
{
    EXPECT_FALSE(gather_system_facts(root_).has_our_rules);
    write("etc/udev/rules.d/70-tractus.rules", "");
    EXPECT_TRUE(gather_system_facts(root_).has_our_rules);
}

TEST(SystemFacts, SurvivesAMachineWithoutAnything)
{
    auto const facts = gather_system_facts("/nowhere");
    EXPECT_TRUE(facts.devices.empty());
    EXPECT_TRUE(facts.usb.empty());
    EXPECT_FALSE(facts.has_hidraw);
}

TEST(LibraryVersions, AreRecentEnoughHere)
{
    auto const libraries = drivers::library_versions();
    ASSERT_EQ(libraries.size(), 3u);
    for (auto const& library : libraries)
        EXPECT_FALSE(drivers::is_older_version(library.version, library.needed)) << library.name;
}

TEST(IsOlderVersion, ComparesNumberByNumber)
{
    EXPECT_TRUE(drivers::is_older_version("0.9.0", "0.10"));
    EXPECT_TRUE(drivers::is_older_version("1.6", "1.6.1"));
    EXPECT_FALSE(drivers::is_older_version("1.6.3", "1.6"));
    EXPECT_FALSE(drivers::is_older_version("2.2", "1.6.3"));
    EXPECT_FALSE(drivers::is_older_version("1.0", "1.0.0"));
}

} // namespace
} // namespace tractus::diagnosis
