#include "drivers/links/event_source.h"

#include "drivers/device_kind.h"
#include "drivers/tablets/pen_decoders.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <libevdev/libevdev-uinput.h>
#include <libevdev/libevdev.h>
#include <memory>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tractus::drivers {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

using Evdev = std::unique_ptr<libevdev, void (*)(libevdev*)>;

// Returns a description of a pen of 260 x 170 mm, as in a Surface computer.
Evdev surface_pen()
{
    Evdev device(libevdev_new(), libevdev_free);
    libevdev_set_name(device.get(), "Surface Pen");
    libevdev_set_id_bustype(device.get(), 0x18);
    for (auto const key : { BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOUCH, BTN_STYLUS })
        libevdev_enable_event_code(device.get(), EV_KEY, static_cast<unsigned>(key), nullptr);
    auto const add_axis = [&](unsigned code, int maximum, int resolution) {
        input_absinfo axis {};
        axis.maximum = maximum;
        axis.resolution = resolution;
        libevdev_enable_event_code(device.get(), EV_ABS, code, &axis);
    };
    add_axis(ABS_X, 26000, 100);
    add_axis(ABS_Y, 17000, 100);
    add_axis(ABS_PRESSURE, 4095, 0);
    return device;
}

TEST(EventSource, KnowsWhatADeviceSaysOfItself)
{
    auto const abilities = abilities_of(*surface_pen());
    EXPECT_TRUE(is_event_pen(abilities));
    EXPECT_EQ(abilities.keys.size(), 4u);
    EXPECT_EQ(abilities.axes.at(ABS_Y).maximum, 17000);
    EXPECT_EQ(abilities.axes.at(ABS_Y).resolution, 100);
    DeviceInfo const info { .name = "Surface Pen",
                            .physical_path = event_pen_path("i2c"),
                            // Vendor id of a maker with known report formats, which must be
                            // ignored.
                            .vendor_id = 0x056a,
                            .product_id = 0x037a,
                            .report_descriptor = describe_event_pen(abilities) };
    auto const pen = make_pen_decoder(info);
    ASSERT_TRUE(pen) << pen.error().message;
    EXPECT_NEAR((*pen)->traits().size_mm.x(), 260, 1e-6);
    EXPECT_FALSE((*pen)->traits().is_size_assumed);
    EXPECT_TRUE((*pen)->traits().has_eraser);
    EXPECT_EQ((*pen)->traits().button_count, 1u);
    EXPECT_EQ((*pen)->traits().raw_pressure_maximum, 4095);
}

class EventPenList : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(root_); }
    void TearDown() override { fs::remove_all(root_); }

    // Adds an input device as in sysfs; the words of its bit maps are written highest first.
    void add(std::string const& event, std::string const& keys, std::string const& axes) const
    {
        auto const device = root_ / "sys/class/input" / event / "device";
        fs::create_directories(device / "capabilities");
        fs::create_directories(device / "id");
        std::ofstream(device / "name") << "Pen of " << event << '\n';
        std::ofstream(device / "phys") << "i2c-NTRG0001:01\n";
        std::ofstream(device / "id/vendor") << "1b96\n";
        std::ofstream(device / "capabilities/key") << keys << '\n';
        std::ofstream(device / "capabilities/abs") << axes << '\n';
    }

    fs::path root_ = fs::temp_directory_path() / ("tractus_events_" + std::to_string(::getpid()));
};

// Bit maps of a pen in sysfs: keys 0x140, 0x14a and 0x14b are bits 0, 10 and 11 of the sixth word.
constexpr char const* kPenKeys = "c01 0 0 0 0 0";
constexpr char const* kTouchKeys = "400 0 0 0 0 0";
constexpr char const* kPenAxes = "1000003";

TEST_F(EventPenList, HasThePensThatNoHidrawNodeServes)
{
    add("event3", kPenKeys, kPenAxes);
    add("event4", kTouchKeys, kPenAxes);
    add("event5", kPenKeys, "0");
    add("event6", "402000000 3803078f800d001 feffffdfffefffff fffffffffffffffe", "0");
    add("event7", kPenKeys, kPenAxes);
    fs::create_directories(root_ / "sys/class/input/event7/device/device/hidraw/hidraw0");
    add("mouse0", kPenKeys, kPenAxes);
    auto const pens = list_event_pens(root_);
    ASSERT_EQ(pens.size(), 1u);
    EXPECT_EQ(pens[0].location, "/dev/input/event3");
    EXPECT_EQ(pens[0].name, "Pen of event3");
    EXPECT_EQ(pens[0].vendor_id, 0x1b96);
    EXPECT_TRUE(has_event_pen_reports(pens[0]));
    auto const described = describe_device(pens[0]);
    EXPECT_EQ(described.kind, DeviceKind::Other) << "its node is not there to be read";
    EXPECT_NE(described.text.find("adduser"), std::string::npos);
    EXPECT_TRUE(list_event_pens(root_ / "none").empty());
}

TEST(EventSource, SaysWhatIsWrongAtOpening)
{
    EXPECT_NE(open_event_pen({ .location = "/dev/input/event-none" })
                  .error()
                  .message.find("cannot open /dev/input/event-none"),
              std::string::npos);
    EXPECT_NE(open_event_pen({ .location = "/dev/null" }).error().message.find("no input device"),
              std::string::npos);
}

TEST(EventSource, ReadsAPenOfTheKernel)
{
    libevdev_uinput* made = nullptr;
    if (libevdev_uinput_create_from_device(surface_pen().get(), LIBEVDEV_UINPUT_OPEN_MANAGED, &made)
        < 0)
        GTEST_SKIP() << "this kernel lets nobody make an input device (/dev/uinput)";
    std::unique_ptr<libevdev_uinput, void (*)(libevdev_uinput*)> kernel(made,
                                                                        libevdev_uinput_destroy);
    auto opened = open_event_pen({ .name = "Surface Pen",
                                   .location = libevdev_uinput_get_devnode(kernel.get()),
                                   .physical_path = event_pen_path("") });
    ASSERT_TRUE(opened) << opened.error().message;
    auto& source = **opened;
    auto const frame
        = [&](std::vector<std::pair<std::pair<unsigned, unsigned>, int>> const& events) {
              for (auto const& [code, value] : events)
                  libevdev_uinput_write_event(kernel.get(), code.first, code.second, value);
              libevdev_uinput_write_event(kernel.get(), EV_SYN, SYN_REPORT, 0);
          };
    frame({ { { EV_KEY, BTN_TOOL_PEN }, 1 },
            { { EV_ABS, ABS_X }, 1000 },
            { { EV_ABS, ABS_Y }, 7000 } });
    frame({ { { EV_KEY, BTN_TOUCH }, 1 }, { { EV_ABS, ABS_PRESSURE }, 2048 } });
    auto decoder = make_pen_decoder(source.info()).value();
    std::vector<PenSample> samples;
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(decoder->decode(source.read(60s).value().value(), samples));
    ASSERT_EQ(samples.size(), 2u);
    EXPECT_NEAR(samples[1].position_mm.x(), 10, 1e-6);
    EXPECT_NEAR(samples[1].position_mm.y(), 100, 1e-6);
    EXPECT_TRUE(samples[1].touching);
    kernel.reset();
    for (int i = 0; i < 10; ++i) // The pen leaves before the device is gone.
        if (!source.read(1s))
            return;
    FAIL() << "the device is gone";
}

} // namespace
} // namespace tractus::drivers
