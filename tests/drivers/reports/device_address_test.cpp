#include "drivers/reports/device_address.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

TEST(DeviceAddress, ReadsWhatItPrints)
{
    for (auto const* const text :
         { "/dev/hidraw3", "libusb:1-2.3:0", "usb:2-1", "usb:1-1.2.3.4.5.6.7",
           "gpio:gpiochip0:11,10,9,8:mcp3208:0", "gpio:CP2112 at 10c4:ea90:0,1,2,3:mcp3008:7",
           "gpio:gpiochip0:17,27:quadrature", "gpio:a:b:0,1:quadrature", "/dev/ttyACM0",
           "/dev/serial/by-id/usb-Arduino-if00", "/dev/pts/3", "/dev/input/event5",
           "iio:device0:voltage1", "iio:ads1015:voltage0-voltage1" }) {
        auto const address = parse_device_address(text);
        ASSERT_TRUE(address) << address.error().message;
        EXPECT_EQ(print_device_address(*address), text);
    }
}

TEST(DeviceAddress, NamesTheConvertersLines)
{
    auto const address = parse_device_address("gpio:pinctrl-bcm2711:11,10,9,8:mcp3208:5").value();
    EXPECT_EQ(address,
              DeviceAddress(GpioAddress { .chip = "pinctrl-bcm2711",
                                          .clk_line = 11,
                                          .din_line = 10,
                                          .dout_line = 9,
                                          .cs_line = 8,
                                          .converter = "mcp3208",
                                          .channel = 5 }));
}

TEST(DeviceAddress, KnowsTheWayThroughHubs)
{
    auto const address = parse_device_address("libusb:3-10.2:1").value();
    EXPECT_EQ(address, DeviceAddress(LibusbAddress { { .bus = 3, .ports = { 10, 2 } }, 1 }));
}

TEST(DeviceAddress, RefusesWhatIsNone)
{
    for (auto const* const text : { "",
                                    "/dev/hidraw",
                                    "/dev/hidraw3x",
                                    "/dev/input/event",
                                    "/dev/input/mouse0",
                                    "/dev/tty",
                                    "iio:device0",
                                    "iio::voltage0",
                                    "iio:../x:voltage0",
                                    "iio:device0:../../etc",
                                    "hidraw3",
                                    "libusb:1-2",
                                    "libusb:1-2:",
                                    "libusb:1-2:-1",
                                    "libusb:0-2:0",
                                    "usb:",
                                    "usb:1",
                                    "usb:1-",
                                    "usb:1-0",
                                    "usb:1-2..3",
                                    "usb:1-1.1.1.1.1.1.1.1",
                                    "usb:99999999999-1",
                                    "gpio:",
                                    "gpio:c:1,2,3:a:0",
                                    "gpio:c:1,2,3,4:a:",
                                    "gpio::1,2,3,4:a:0",
                                    "gpio:c:1,2,3,x:a:0",
                                    "gpio:c:1:quadrature",
                                    "gpio::1,2:quadrature",
                                    "gpio:c:1,x:quadrature" }) {
        auto const address = parse_device_address(text);
        ASSERT_FALSE(address) << text;
        EXPECT_EQ(address.error().fault, Fault::User);
        EXPECT_NE(address.error().message.find("expected"), std::string::npos);
    }
}

} // namespace
} // namespace tractus::drivers
