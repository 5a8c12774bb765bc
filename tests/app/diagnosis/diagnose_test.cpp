#include "app/diagnosis/diagnose.h"

#include "drivers/gpio/gpio_encoder.h"
#include "tests/app/diagnosis/reports.h"
#include "tests/drivers/devices.h"

#include <cerrno>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::diagnosis {
namespace {

DeviceFacts facts_of(drivers::DeviceInfo info, std::string location = "/dev/hidraw3")
{
    info.location = std::move(location);
    return { .info = info, .description = drivers::describe_device(info), .poll_hz = {} };
}

// Returns a Wacom tablet whose vendor-defined reports are longer than those of an Intuos.
drivers::DeviceInfo secretive_tablet()
{
    return { .name = "New Tablet",
             .vendor_id = 0x056a,
             .product_id = 0xfffe,
             .report_descriptor = drivers::bytes(
                 "06 00 ff 09 01 a1 01 85 10 09 02 15 00 26 ff 00 75 08 95 0b 81 02 c0") };
}

std::vector<std::string> kinds(std::vector<Finding> const& findings)
{
    std::vector<std::string> names;
    for (auto const& finding : findings)
        names.emplace_back(name_of(finding.kind));
    return names;
}

using Names = std::vector<std::string>;

bool mentions(Finding const& finding, std::string const& text)
{
    for (auto const& line : finding.remedy)
        if (line.find(text) != std::string::npos)
            return true;
    return finding.what.find(text) != std::string::npos;
}

TEST(DiagnoseSystem, FindsNothingWhereAllIsWell)
{
    EXPECT_TRUE(diagnose_system({ .devices = { facts_of(drivers::simple_pen()) } }).empty());
}

TEST(DiagnoseSystem, PrintsTheRuleThatPermitsADevice)
{
    auto device = facts_of(drivers::simple_pen());
    device.open_error = EACCES;
    auto const findings = diagnose_system({ .devices = { device } });
    ASSERT_EQ(kinds(findings), Names { "not-permitted" });
    EXPECT_EQ(findings[0].subject, "Simple Pen (1209:0002) at /dev/hidraw3");
    EXPECT_TRUE(mentions(findings[0], "Permission denied"));
    EXPECT_TRUE(mentions(findings[0],
                         "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1209\", "
                         "ATTRS{idProduct}==\"0002\", TAG+=\"uaccess\""));
    EXPECT_EQ(findings[0].remedy.front(), "sudo tractus doctor --install-rules");
}

TEST(DiagnoseSystem, AdvisesFirstTheRuleThatWorksWhereOurRulesDoNotNameTheDevice)
{
    // A mouse by an unknown manufacturer that reports tip pressure.
    auto device = facts_of(drivers::simple_pen());
    device.open_error = EACCES;
    device.info.vendor_id = 0x2179;
    device.info.report_descriptor.clear();
    auto const findings = diagnose_system({ .devices = { device } });
    ASSERT_EQ(kinds(findings), Names { "not-permitted" });
    EXPECT_EQ(findings[0].remedy.front(),
              "echo 'KERNEL==\"hidraw*\", ATTRS{idVendor}==\"2179\", ATTRS{idProduct}==\"0002\", "
              "TAG+=\"uaccess\"' | sudo tee /etc/udev/rules.d/71-tractus-2179-0002.rules");
}

TEST(DiagnoseSystem, SaysWhatToDoAboutTheKernelsDriverOfAConverter)
{
    HiddenHidFacts chip { .name = "0003:04D8:00DD.0001",
                          .vendor_id = 0x04d8,
                          .product_id = 0x00dd,
                          .driver = "mcp2221" };
    auto const facts = [&] {
        return SystemFacts { .devices = { facts_of(drivers::simple_pen()) }, .hidden = { chip } };
    };
    auto const findings = diagnose_system(facts());
    ASSERT_EQ(kinds(findings), Names { "driver-in-the-way" });
    EXPECT_EQ(findings[0].subject, "MCP2221A 0003:04D8:00DD.0001");
    EXPECT_TRUE(mentions(findings[0], "blacklist hid_mcp2221"));
    // No problem must be found for other devices, which have a kernel driver.
    chip.product_id = 0x00de;
    EXPECT_EQ(kinds(diagnose_system(facts())), Names {});
}

TEST(DiagnoseSystem, DoesNotMindAKeyboardThatMayNotBeRead)
{
    drivers::DeviceInfo const keyboard { .name = "Keyboard",
                                         .vendor_id = 0x046d,
                                         .report_descriptor
                                         = drivers::bytes("05 01 09 06 a1 01 c0") };
    auto device = facts_of(keyboard);
    device.open_error = EACCES;
    EXPECT_EQ(kinds(diagnose_system({ .devices = { device } })), Names { "no-tablet" });
}

TEST(DiagnoseSystem, SaysWhatAnUnknownTabletsReportsShouldHold)
{
    auto const findings = diagnose_system({ .devices = { facts_of(secretive_tablet()) } });
    ASSERT_EQ(kinds(findings), Names { "unknown-tablet" });
    EXPECT_TRUE(mentions(findings[0], "pressure"));
    EXPECT_TRUE(mentions(findings[0],
                         "tractus record -o my-tablet.tractus-log --seconds 30 "
                         "--device /dev/hidraw3"));
}

TEST(DiagnoseSystem, ReportsAnUnknownTabletOnce)
{
    EXPECT_EQ(
        kinds(diagnose_system({ .devices = { facts_of(secretive_tablet(), "/dev/hidraw0"),
                                             facts_of(secretive_tablet(), "/dev/hidraw1") } })),
        Names { "unknown-tablet" });
}

UsbDeviceFacts usb_tablet(std::string driver, bool has_node)
{
    return { .port = "1-2",
             .vendor_id = 0x256c,
             .product_id = 0x006e,
             .name = "Tablet",
             .interfaces
             = { { .number = 1, .usb_class = 3, .driver = driver, .has_node = has_node } } };
}

TEST(DiagnoseSystem, FindsATabletWithoutADriver)
{
    auto const findings = diagnose_system({ .usb = { usb_tablet("", false) } });
    ASSERT_EQ(kinds(findings), Names { "no-driver" });
    EXPECT_TRUE(mentions(findings[0], "modprobe usbhid"));
    EXPECT_TRUE(mentions(findings[0], "libusb:1-2:1"));
}

TEST(DiagnoseSystem, FindsWhatHoldsATablet)
{
    EXPECT_EQ(kinds(diagnose_system({ .usb = { usb_tablet("usbfs", false) } })),
              Names { "driver-in-the-way" });
    EXPECT_EQ(kinds(diagnose_system({ .devices = { facts_of(drivers::simple_pen()) },
                                      .usb = { usb_tablet("usbhid", true) } })),
              Names {});
}

TEST(DiagnoseSystem, NamesAnOldLibrary)
{
    auto const findings = diagnose_system(
        { .devices = { facts_of(drivers::simple_pen()) },
          .libraries = { { "hidapi", "0.9.0", "0.10.0" }, { "libusb", "1.0.26", "1.0.22" } } });
    ASSERT_EQ(kinds(findings), Names { "old-library" });
    EXPECT_EQ(findings[0].subject, "hidapi");
}

DeviceReading reading_after(drivers::DeviceInfo const& info, std::string const& report, int count)
{
    DeviceMonitor monitor(info);
    for (int i = 0; i < count; ++i)
        monitor.push(report_at_ms(8 * i, report));
    return monitor.reading();
}

TEST(DiagnoseDevice, FindsNothingWhereAllIsWell)
{
    EXPECT_TRUE(diagnose_device(reading_after(drivers::simple_pen(), kTouching, 100),
                                std::chrono::seconds(1))
                    .empty());
}

TEST(DiagnoseDevice, TellsMouseModeFromUnknownReports)
{
    auto tablet = secretive_tablet();
    auto const mouse
        = drivers::bytes("05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 "
                         "03 75 01 81 02 95 05 81 03 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 "
                         "81 06 c0 c0");
    tablet.report_descriptor.insert(tablet.report_descriptor.end(), mouse.begin(), mouse.end());
    EXPECT_EQ(kinds(diagnose_device(reading_after(tablet, "01 00 05 05", 50), {})),
              Names { "mouse-mode" });
    EXPECT_EQ(kinds(diagnose_device(
                  reading_after(tablet, "10 00 05 05 00 00 00 00 00 00 00 00", 50), {})),
              Names { "unknown-tablet" });
    EXPECT_EQ(kinds(diagnose_device(reading_after(tablet, "01 00 05 05", 5), {})), Names {});
}

TEST(DiagnoseDevice, NamesBrokenReports)
{
    auto const findings = diagnose_device(reading_after(drivers::simple_pen(), "02 21 00", 3), {});
    ASSERT_EQ(kinds(findings), Names { "broken-reports" });
    EXPECT_TRUE(mentions(findings[0], "3 of 3 reports"));
}

TEST(DiagnoseDevice, AsksForThePenOfATabletWhoseKeysAreAllThatSpoke)
{
    // An HS610 in its full mode. The user turns its dial.
    drivers::DeviceInfo const hs610 { .name = "Huion HS610",
                                      .interface_number = 0,
                                      .vendor_id = 0x256c,
                                      .product_id = 0x006d,
                                      .strings = { { 200, "" }, { 201, "HUION_T194_190116" } } };
    auto const findings
        = diagnose_device(reading_after(hs610, "08 f0 01 01 00 03 00 00 00 00 00 00", 50), {});
    ASSERT_EQ(kinds(findings), Names { "silent" });
    EXPECT_TRUE(mentions(findings[0], "none of them is of a pen"));
}

TEST(DiagnoseDevice, NamesASensorOnItsRail)
{
    EXPECT_EQ(
        kinds(diagnose_device(reading_after(drivers::simple_height_sensor(), "01 00 00", 100), {})),
        Names { "height-fault" });
}

TEST(DiagnoseDevice, NamesASensorThatNeverSpoke)
{
    auto const reading = DeviceMonitor(drivers::simple_height_sensor()).reading();
    EXPECT_EQ(kinds(diagnose_device(reading, std::chrono::seconds(2))), Names { "silent" });
    EXPECT_EQ(kinds(diagnose_device(reading, {})), Names {});
}

TEST(DiagnoseDevice, NamesTimesThatGoBackwards)
{
    DeviceMonitor monitor(drivers::simple_pen());
    monitor.push(report_at_ms(10, kTouching));
    monitor.push(report_at_ms(5, kTouching));
    EXPECT_EQ(kinds(diagnose_device(monitor.reading(), {})), Names { "clock-jump" });
}

// Returns a report of simple_pen() that touches or hovers. `x` is in counts and `pressure` at most
// 2047; y is fixed.
std::string pen_report(bool touches, int x, int pressure)
{
    return fmt::format("02 {} {:02x} {:02x} 88 13 {:02x} {:02x} 00 00", touches ? "21" : "20",
                       x & 0xff, x >> 8, pressure & 0xff, pressure >> 8);
}

// Returns the reading of a pen that draws strokes of 40 reports, with pauses of ten reports. In the
// pauses the pen is lifted if `lifts` is true; otherwise it touches with the pressure `resting`.
DeviceReading reading_of_strokes(bool lifts, int resting, int pressing)
{
    DeviceMonitor monitor(drivers::simple_pen());
    for (int i = 0; i < 270; ++i) {
        bool const draws = i % 50 >= 10;
        monitor.push(
            report_at_ms(8 * i, pen_report(draws || !lifts, 40 * i, draws ? pressing : resting)));
    }
    return monitor.reading();
}

TEST(DiagnoseDevice, NamesAPenThatNeverLifts)
{
    auto const findings = diagnose_device(reading_of_strokes(false, 40, 900), {});
    ASSERT_EQ(kinds(findings), Names { "pen-never-lifts" });
    EXPECT_TRUE(mentions(findings[0], "all of its 270 samples touch"));
    EXPECT_TRUE(mentions(findings[0], "pressure_threshold = 0.05")) << findings[0].remedy[0];
    EXPECT_EQ(kinds(diagnose_device(reading_of_strokes(false, 40, 40), {})),
              Names { "pen-never-lifts" });
    EXPECT_EQ(kinds(diagnose_device(reading_of_strokes(true, 0, 900), {})), Names {});
    EXPECT_EQ(kinds(diagnose_device(reading_of_strokes(false, 900, 900), {})), Names {})
        << "one long stroke";
}

// Returns simple_pen() with an additional mouse, whose reports have the ID 1.
drivers::DeviceInfo pen_with_mouse()
{
    auto info = drivers::simple_pen();
    auto const mouse
        = drivers::bytes("05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 "
                         "03 75 01 81 02 95 05 81 03 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 "
                         "81 06 c0 c0");
    info.report_descriptor.insert(info.report_descriptor.end(), mouse.begin(), mouse.end());
    return info;
}

TEST(DiagnoseDevice, NamesAModeThatIsLostInMidRecording)
{
    auto const findings_of = [](std::vector<std::pair<char const*, int>> const& parts) {
        DeviceMonitor monitor(pen_with_mouse());
        int time_ms = 0;
        for (auto const& [report, count] : parts)
            for (int i = 0; i < count; ++i)
                monitor.push(report_at_ms(time_ms += 8, report));
        return diagnose_device(monitor.reading(), {});
    };
    constexpr char const* kHovering = "02 20 10 27 88 13 00 00 00 00";
    constexpr char const* kMoving = "01 00 05 05";
    auto const findings = findings_of({ { kHovering, 100 }, { kMoving, 50 } });
    ASSERT_EQ(kinds(findings), Names { "mouse-mode" });
    EXPECT_TRUE(mentions(findings[0], "At 0.8 s it lost its full mode"));
    EXPECT_EQ(kinds(findings_of({ { kMoving, 50 }, { kHovering, 100 } })), Names {})
        << "it was switched";
    EXPECT_EQ(kinds(findings_of({ { kHovering, 50 }, { kMoving, 50 }, { kHovering, 50 } })),
              Names {})
        << "a wheel beside the pen";
    EXPECT_EQ(kinds(findings_of({ { kHovering, 100 }, { kMoving, 10 } })), Names {});
}

TEST(DiagnoseDevice, NamesTheDriverThatSwitchesATabletOfGenius)
{
    // The tablet before the kernel driver hid_kye has switched it: it is a mouse with absolute
    // positions and pressure.
    drivers::DeviceInfo info { .name = "EasyPen", .vendor_id = 0x0458, .product_id = 0x5013 };
    info.report_descriptor
        = drivers::bytes("05 01 09 02 a1 01 85 11 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 "
                         "75 01 81 02 95 05 81 01 05 01 09 30 09 31 26 ff 7f 95 02 75 10 81 02 05 "
                         "0d 09 30 26 ff 03 95 01 81 02 c0 c0");
    auto const reading = reading_after(info, "11 01 10 10 10 10 00 02", 50);
    EXPECT_EQ(reading.samples, 50u);
    auto const findings = diagnose_device(reading, {});
    ASSERT_EQ(kinds(findings), Names { "mouse-mode" });
    EXPECT_TRUE(mentions(findings[0], "modprobe hid_kye"));
    info.vendor_id = 0x256c; // The same descriptor is fine for tablets of other manufacturers.
    EXPECT_EQ(kinds(diagnose_device(reading_after(info, "11 01 10 10 10 10 00 02", 50), {})),
              Names {});
    info.vendor_id = 0x0458;
    info.product_id = 0x0185; // Another product of this manufacturer, a mouse.
    info.report_descriptor.resize(info.report_descriptor.size() - 12);
    info.report_descriptor.insert(info.report_descriptor.end(), 2, std::byte { 0xc0 });
    EXPECT_EQ(kinds(diagnose_device(reading_after(info, "11 01 10 10 10 10", 50), {})), Names {});
}

TEST(DiagnoseDevice, SaysHowADeskFindsItsPlaceAgainInMidRecording)
{
    drivers::DeviceInfo const desk { .name = "USB Control Link",
                                     .vendor_id = 0x12d3,
                                     .product_id = 0x0002 };
    auto lost = std::string("04 38");
    for (int i = 0; i < 62; ++i)
        lost += " 00";
    auto const findings = diagnose_device(reading_after(desk, lost, 50), {});
    ASSERT_FALSE(findings.empty());
    EXPECT_EQ(name_of(findings[0].kind), "height-fault");
    EXPECT_TRUE(mentions(findings[0], "own down key"));
    EXPECT_FALSE(mentions(findings[0], "shorter cable"));
}

// Returns the readings of two device nodes. The second sends the same reports as the first,
// `later_ms` later and with positions displaced by `moved` counts.
std::vector<DeviceReading> readings_of_two_nodes(drivers::DeviceInfo second, int later_ms,
                                                 int moved)
{
    auto const first = drivers::simple_pen();
    DeviceMonitor a(first);
    DeviceMonitor b(second);
    for (int i = 0; i < 300; ++i) {
        bool const touches = i % 50 >= 10;
        a.push(report_at_ms(8 * i, pen_report(touches, 40 * i, 900)));
        b.push(report_at_ms(8 * i + later_ms, pen_report(touches, 40 * i + moved, 900)));
    }
    return { a.reading(), b.reading() };
}

TEST(DiagnoseTogether, NamesATabletThatSendsEachReportTwice)
{
    auto twin = drivers::simple_pen();
    twin.location = "/dev/hidraw7";
    twin.physical_path = "usb-0000:00:14.0-1/input2";
    auto const findings = diagnose_together(readings_of_two_nodes(twin, 2, 5));
    ASSERT_EQ(kinds(findings), Names { "sent-twice" });
    EXPECT_TRUE(mentions(findings[0], "/dev/hidraw7"));
    EXPECT_EQ(kinds(diagnose_together(readings_of_two_nodes(twin, 2, 3000))), Names {})
        << "two hands on one large tablet";
    EXPECT_EQ(kinds(diagnose_together(readings_of_two_nodes(twin, 120, 5))), Names {});
    twin.physical_path = "usb-0000:00:14.0-2/input0";
    EXPECT_EQ(kinds(diagnose_together(readings_of_two_nodes(twin, 2, 5))), Names {})
        << "another tablet of the same kind";
}

TEST(DiagnoseTogether, NamesAModeThatIsLostWhereAnotherNodeTakesOver)
{
    // A Huion in its full mode: interface 0 sends vendor-defined reports, interface 1 is a mouse.
    drivers::DeviceInfo const full { .name = "Huion HS610",
                                     .physical_path = "usb-1/input0",
                                     .interface_number = 0,
                                     .vendor_id = 0x256c,
                                     .product_id = 0x006d,
                                     .strings = { { 200, "" }, { 201, "HUION_T194_190116" } } };
    auto lesser = pen_with_mouse();
    lesser.vendor_id = full.vendor_id;
    lesser.product_id = full.product_id;
    lesser.physical_path = "usb-1/input1";
    auto const findings_of = [&](int full_begin_ms, int lesser_begin_ms) {
        DeviceMonitor a(full);
        DeviceMonitor b(lesser);
        for (int i = 0; i < 60; ++i) {
            a.push(report_at_ms(full_begin_ms + 8 * i, "08 80 10 10 10 10 00 00 00 00 00 00"));
            b.push(report_at_ms(lesser_begin_ms + 8 * i, "01 00 05 05"));
        }
        EXPECT_EQ(a.reading().samples, 60u);
        return diagnose_together(std::vector { a.reading(), b.reading() });
    };
    EXPECT_EQ(kinds(findings_of(0, 1000)), Names { "mouse-mode" });
    EXPECT_EQ(kinds(findings_of(1000, 0)), Names {}) << "it was switched";
    EXPECT_EQ(kinds(findings_of(0, 100)), Names {}) << "both at once";
}

TEST(DiagnoseRefusal, KeepsTheReason)
{
    auto const finding = diagnose_refusal(drivers::simple_pen(),
                                          { Fault::User, "another program has its interface" });
    EXPECT_EQ(name_of(finding.kind), "driver-in-the-way");
    EXPECT_TRUE(mentions(finding, "another program has its interface"));
}

TEST(DiagnoseDevice, SaysWhatToDoAboutAnEncodersLostEdges)
{
    DeviceReading reading;
    reading.info = drivers::describe_gpio_encoder("gpio:gpiochip0:17,27:quadrature").value();
    reading.reports = 100;
    reading.broken_reports = 1;
    reading.first_broken = "the encoder has lost 3 edges";
    auto const findings = diagnose_device(reading, std::chrono::seconds(3));
    ASSERT_EQ(kinds(findings), Names { "broken-reports" });
    EXPECT_TRUE(mentions(findings[0], "the encoder has lost 3 edges"));
    EXPECT_TRUE(mentions(findings[0], "calibrate zero"));
}

TEST(DiagnoseRefusal, SaysHowADeskFindsItsPlaceAgain)
{
    drivers::DeviceInfo const desk { .name = "USB Control Link",
                                     .location = "/dev/hidraw3",
                                     .vendor_id = 0x12d3,
                                     .product_id = 0x0002 };
    auto const finding
        = diagnose_refusal(desk, { Fault::User, "the desk does not know how high it is" });
    EXPECT_EQ(name_of(finding.kind), "height-fault");
    EXPECT_TRUE(mentions(finding, "the desk does not know how high it is"));
    EXPECT_TRUE(mentions(finding, "own down key"));
}

TEST(DiagnoseClocks, TellsSleepFromASetClock)
{
    using namespace std::chrono_literals;
    ClockReading const before { .monotonic = 10s, .boottime = 12s, .realtime = 1000s };
    EXPECT_TRUE(diagnose_clocks(before, { 13s, 15s, 1003s }).empty());
    auto const slept = diagnose_clocks(before, { 13s, 75s, 1063s });
    ASSERT_EQ(kinds(slept), Names { "clock-jump" });
    EXPECT_TRUE(mentions(slept[0], "slept for 60.0 s"));
    auto const set = diagnose_clocks(before, { 13s, 15s, 1001s });
    ASSERT_EQ(kinds(set), Names { "clock-jump" });
    EXPECT_TRUE(mentions(set[0], "-2.0 s"));
}

TEST(PrintFindings, PutsTheRemedyBelow)
{
    Finding const finding { .kind = FindingKind::Silent,
                            .subject = "sensor",
                            .what = "Nothing came.",
                            .remedy = { "plug it in" } };
    EXPECT_EQ(print_findings(std::span(&finding, 1)),
              "problem: sensor\n    Nothing came.\n      plug it in\n");
    EXPECT_NE(print_findings_json(std::span(&finding, 1)).find("\"kind\": \"silent\""),
              std::string::npos);
}

} // namespace
} // namespace tractus::diagnosis
