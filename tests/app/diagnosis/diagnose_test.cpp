#include "app/diagnosis/diagnose.h"

#include "drivers/gpio/gpio_encoder.h"
#include "tests/app/diagnosis/reports.h"
#include "tests/drivers/devices.h"

#include <cerrno>
#include <gtest/gtest.h>

namespace tractus::diagnosis {
namespace {

DeviceFacts facts_of(drivers::DeviceInfo info, std::string location = "/dev/hidraw3")
{
    info.location = std::move(location);
    return { .info = info, .description = drivers::describe_device(info), .poll_hz = {} };
}

// A Wacom whose reports are its maker's own, and longer than an Intuos's.
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
    // A mouse with a tip's pressure, of somebody unknown.
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
    chip.product_id = 0x00de; // Another device may keep to itself what it likes.
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
    // An HS610 in its full mode: a dial of its pad.
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
