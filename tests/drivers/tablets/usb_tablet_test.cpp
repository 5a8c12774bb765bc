#include "drivers/tablets/usb_tablet.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

namespace fs = std::filesystem;

// Fixture with a folder that imitates /sys/bus/usb/devices.
struct UsbTablets : testing::Test {
    ~UsbTablets() override { fs::remove_all(root); }

    void put(std::string const& file, std::string_view text) const
    {
        fs::create_directories((root / file).parent_path());
        std::ofstream(root / file, std::ios::binary) << text;
    }

    void put_interface(std::string const& port, std::string const& number,
                       std::string const& usb_class) const
    {
        put(port + ":1." + number + "/bInterfaceNumber", "0" + number + "\n");
        put(port + ":1." + number + "/bInterfaceClass", usb_class + "\n");
    }

    fs::path root = fs::path(testing::TempDir())
        / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(UsbTablets, StandAtEachOfTheirInterfaces)
{
    put("1-4.2/idVendor", "256c\n");
    put("1-4.2/idProduct", "006d\n");
    put("1-4.2/product", "PenTablet \n");
    put("1-4.2/serial", "A7\n");
    put_interface("1-4.2", "1", "03");
    put_interface("1-4.2", "0", "03");
    put_interface("1-4.2", "2", "ff");
    auto const found = list_usb_tablets(root);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].location, "libusb:1-4.2:0");
    EXPECT_EQ(found[1].location, "libusb:1-4.2:1");
    EXPECT_EQ(found[1].interface_number, 1);
    EXPECT_EQ(found[1].vendor_id, 0x256c);
    EXPECT_EQ(found[1].product_id, 0x006d);
    EXPECT_EQ(found[1].name, "PenTablet");
    EXPECT_EQ(found[1].serial_number, "A7");
}

TEST_F(UsbTablets, AreNoneWhereThereIsNoUsb)
{
    EXPECT_TRUE(list_usb_tablets(root).empty());
}

} // namespace
} // namespace tractus::drivers
