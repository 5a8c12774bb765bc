#include "drivers/sensors/usb_sensor_list.h"

#include "drivers/height_decoders.h"
#include "sim/height_sensor_frames.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

namespace fs = std::filesystem;

// Fixture with a folder that imitates /sys/bus/usb/devices.
struct UsbSensorList : testing::Test {
    UsbSensorList() { fs::create_directories(root); }
    ~UsbSensorList() override { fs::remove_all(root); }

    void put(std::string const& file, std::string_view text) const
    {
        fs::create_directories((root / file).parent_path());
        std::ofstream(root / file, std::ios::binary) << text;
    }

    void put_own_sensor(std::string const& port) const
    {
        sim::HeightSensorModel const model;
        std::string descriptors;
        for (auto const& part :
             { model.device_descriptor(), model.configuration_descriptor(sim::UsbSpeed::Full) })
            for (auto const byte : part)
                descriptors += std::to_integer<char>(byte);
        put(port + "/descriptors", descriptors);
        put(port + "/idVendor", "1209\n");
        put(port + "/idProduct", "0002\n");
        put(port + "/manufacturer", "tractus\n");
        put(port + "/product", "Height sensor\n");
        put(port + "/serial", "0001\n");
        put(port + ":1.0/bInterfaceNumber", "00\n");
        put(port + ":1.0/bInterfaceClass", "ff\n");
        put(port + ":1.0/bInterfaceSubClass", "54\n");
        put(port + ":1.0/bInterfaceProtocol", "01\n");
        put(port + ":1.0/interface", model.interface_string() + "\n");
    }

    fs::path root = fs::path(testing::TempDir())
        / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(UsbSensorList, FindsTheStationsOwnSensor)
{
    put_own_sensor("1-2.3");
    auto const sensors = list_usb_height_sensors(root);
    ASSERT_EQ(sensors.size(), 1u);
    auto const& info = sensors[0];
    EXPECT_EQ(info.name, "Height sensor");
    EXPECT_EQ(info.manufacturer, "tractus");
    EXPECT_EQ(info.serial_number, "0001");
    EXPECT_EQ(info.location, "usb:1-2.3");
    EXPECT_EQ(info.interface_number, 0);
    EXPECT_EQ(info.vendor_id, 0x1209);
    EXPECT_EQ(info.product_id, 0x0002);
    EXPECT_EQ(info.strings.at(4), "tractus height sensor 1, full scale 4095");
    EXPECT_EQ(make_height_decoder(info).value()->full_scale(), 4095);
}

TEST_F(UsbSensorList, FindsALabJack)
{
    put("2-1/idVendor", "0cd5\n");
    put("2-1/idProduct", "0003\n");
    put("2-1:1.0/bInterfaceNumber", "00\n");
    put("2-1:1.0/bInterfaceClass", "ff\n");
    auto const sensors = list_usb_height_sensors(root);
    ASSERT_EQ(sensors.size(), 1u);
    EXPECT_EQ(sensors[0].name, "LabJack U3");
    EXPECT_TRUE(make_height_decoder(sensors[0]));
}

TEST_F(UsbSensorList, LeavesOtherDevicesOut)
{
    put("1-1/idVendor", "056a\n");
    put("1-1:1.0/bInterfaceClass", "03\n");
    put("usb1/idVendor", "1d6b\n");
    put_own_sensor("1-4");
    put("1-4:1.0/bInterfaceProtocol", "02\n");
    EXPECT_TRUE(list_usb_height_sensors(root).empty());
    EXPECT_TRUE(list_usb_height_sensors(root / "nowhere").empty());
}

TEST_F(UsbSensorList, SurvivesDescriptorsThatAreCutOff)
{
    put_own_sensor("1-1");
    put("1-1/descriptors", "\x12\x01\x09");
    EXPECT_EQ(list_usb_height_sensors(root).size(), 1u);
}

TEST_F(UsbSensorList, IsInTheOrderOfThePorts)
{
    for (auto const* const port : { "1-10", "1-2", "1-9" })
        put_own_sensor(port);
    std::vector<std::string> ports;
    for (auto const& info : list_usb_height_sensors(root))
        ports.push_back(info.location);
    EXPECT_EQ(ports, (std::vector<std::string> { "usb:1-2", "usb:1-9", "usb:1-10" }));
}

} // namespace
} // namespace tractus::drivers
