#include "app/diagnosis/diagnose.h"

#include "app/diagnosis/tablet_findings.h"
#include "app/diagnosis/udev_rules.h"
#include "drivers/gpio/gpio_encoder.h"
#include "drivers/library_versions.h"
#include "drivers/sensors/iio_channel.h"
#include "drivers/sensors/linak_desk.h"
#include "drivers/sensors/mcp2221a.h"
#include "drivers/sensors/serial_line.h"
#include "engine/base/printable.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <fmt/core.h>
#include <set>
#include <utility>

namespace tractus::diagnosis {

namespace {

using namespace std::chrono_literals;

constexpr int kHidClass = 3; // USB class of human interface devices.

// Lists ways to get permission, the best one first: the program's udev rules if they cover the
// device, otherwise a udev rule for this model of device alone.
std::vector<std::string> how_to_permit(drivers::DeviceInfo const& info)
{
    constexpr auto kReload = "sudo udevadm control --reload-rules && sudo udevadm trigger";
    auto const own_rule = udev_rule_for(info);
    auto const write_rule
        = fmt::format("echo '{}' | sudo tee /etc/udev/rules.d/71-tractus-{:04x}-{:04x}.rules",
                      own_rule, info.vendor_id, info.product_id);
    if (!do_rules_permit(info))
        return { write_rule, kReload,
                 "tractus's own rules do not name this device. Over ssh nobody sits at the screen: "
                 "write GROUP=\"plugdev\", MODE=\"0660\" in place of TAG+=\"uaccess\", and sudo "
                 "adduser $USER plugdev, then log in again." };
    return { "sudo tractus doctor --install-rules", kReload,
             "Or permit this device alone, with its own rule:", write_rule,
             "Over ssh nobody sits at the screen: install them with --for-group, and sudo adduser "
             "$USER plugdev, then log in again." };
}

Finding not_permitted(DeviceFacts const& device)
{
    return { .kind = FindingKind::NotPermitted,
             .subject = device_subject(device.info),
             .what = fmt::format("The device is there, but you may not read and write it ({}).",
                                 std::strerror(device.open_error)),
             .remedy = how_to_permit(device.info) };
}

// Reports a kernel driver that occupies an MCP2221A, the only supported device for which the kernel
// has a driver that does this.
void diagnose_hidden(HiddenHidFacts const& device, std::vector<Finding>& findings)
{
    drivers::DeviceInfo const ids { .vendor_id = device.vendor_id,
                                    .product_id = device.product_id };
    if (!drivers::is_mcp2221a(ids) || device.driver.empty())
        return;
    findings.push_back(
        { .kind = FindingKind::DriverInTheWay,
          .subject = fmt::format("MCP2221A {}", device.name),
          .what
          = fmt::format("The kernel's driver {} keeps the chip for itself: there is no hidraw "
                        "node through which its converter could be read.",
                        device.driver),
          .remedy = { "echo blacklist hid_mcp2221 | sudo tee /etc/modprobe.d/tractus.conf",
                      "sudo modprobe -r hid_mcp2221",
                      "That is all: its node comes by itself, and the driver does not return." } });
}

void diagnose_found(DeviceFacts const& device, std::vector<Finding>& findings)
{
    bool const known = is_tablet(device.info.vendor_id, device.info.product_id);
    bool const concerns_us = known || device.description.kind != drivers::DeviceKind::Other;
    if (concerns_us && device.open_error != 0)
        findings.push_back(not_permitted(device));
}

// Reports tablets that should have a pen, but of whose device nodes none carries one.
void diagnose_unknown(SystemFacts const& facts, std::vector<Finding>& findings)
{
    std::set<std::pair<std::uint16_t, std::uint16_t>> with_pen;
    for (auto const& device : facts.devices)
        if (device.description.kind == drivers::DeviceKind::Pen)
            with_pen.insert({ device.info.vendor_id, device.info.product_id });
    for (auto const& device : facts.devices) {
        auto const& info = device.info;
        if (!is_tablet(info.vendor_id, info.product_id)
            || !with_pen.insert({ info.vendor_id, info.product_id }).second)
            continue;
        findings.push_back({ .kind = FindingKind::UnknownTablet,
                             .subject = device_subject(info),
                             .what = fmt::format("It is a tablet, but none of its nodes carries a "
                                                 "pen that is known: {}.",
                                                 device.description.text),
                             .remedy = describe_needed_information(info) });
    }
}

void diagnose_usb(UsbDeviceFacts const& device, std::vector<Finding>& findings)
{
    if (!is_tablet(device.vendor_id, device.product_id))
        return;
    for (auto const& interface : device.interfaces) {
        if (interface.usb_class != kHidClass || interface.has_node)
            continue;
        bool const is_bound = !interface.driver.empty();
        bool const is_taken = is_bound && interface.driver != "usbhid";
        findings.push_back(
            { .kind = is_taken ? FindingKind::DriverInTheWay : FindingKind::NoDriver,
              .subject
              = fmt::format("{} ({:04x}:{:04x}) at USB {}, interface {}", device.name,
                            device.vendor_id, device.product_id, device.port, interface.number),
              .what = is_taken
                  ? fmt::format("The kernel's driver or another program holds it as \"{}\", so it "
                                "has no hidraw node.",
                                interface.driver)
                  : "No driver of the kernel makes a hidraw node of it; a program that used it "
                    "through libusb may have left it so.",
              .remedy = { is_taken ? "Close the other tablet program (OpenTabletDriver, a maker's "
                                     "own driver), then unplug the tablet and plug it in again."
                                   : "sudo modprobe usbhid, then unplug the tablet and plug it in "
                                     "again.",
                          fmt::format("Or read it past the kernel: --device libusb:{}:{}",
                                      device.port, interface.number) } });
    }
}

} // namespace

std::vector<Finding> diagnose_system(SystemFacts const& facts)
{
    std::vector<Finding> findings;
    if (!facts.has_hidraw)
        findings.push_back({ .kind = FindingKind::NoDriver,
                             .subject = "the kernel",
                             .what = "It has no hidraw, through which tablets are read.",
                             .remedy = { "Run a kernel with CONFIG_HIDRAW=y: Debian's has it." } });
    for (auto const& device : facts.devices)
        diagnose_found(device, findings);
    diagnose_unknown(facts, findings);
    for (auto const& device : facts.usb)
        diagnose_usb(device, findings);
    for (auto const& device : facts.hidden)
        diagnose_hidden(device, findings);
    for (auto const& library : facts.libraries)
        if (drivers::is_older_version(library.version, library.needed))
            findings.push_back(
                { .kind = FindingKind::OldLibrary,
                  .subject = library.name,
                  .what = fmt::format("Version {} is there, {} or newer is needed.",
                                      library.version, library.needed),
                  .remedy = { "Debian 12 and later have it: sudo apt install --upgrade" } });
    bool const any_tablet
        = std::any_of(facts.devices.begin(), facts.devices.end(), [](auto const& device) {
              return device.description.kind == drivers::DeviceKind::Pen;
          });
    if (!any_tablet && findings.empty())
        findings.push_back({ .kind = FindingKind::NoTablet,
                             .subject = "tablets",
                             .what = "None is plugged in.",
                             .remedy = { "Look whether the kernel sees it: lsusb; journalctl -k -n "
                                         "20",
                                         "Try another cable and another socket: some cables carry "
                                         "power alone.",
                                         "Without one, tractus runs on a simulated tablet: tractus "
                                         "window" } });
    return findings;
}

// Reports that a desk does not answer or has lost its position although its cable works.
static Finding desk_is_lost(drivers::DeviceInfo const& info, std::string what)
{
    return { .kind = FindingKind::HeightFault,
             .subject = device_subject(info),
             .what = std::move(what),
             .remedy = { "See that the cable is in the desk's control box, and the box has mains.",
                         "Hold the desk's own down key until it is at its lowest, and for ten "
                         "seconds more: it finds its place again.",
                         "Close other programs that use the cable." } };
}

Finding diagnose_refusal(drivers::DeviceInfo const& info, Error const& error)
{
    if (drivers::is_linak_desk(info))
        return desk_is_lost(info,
                            fmt::format("It may be read, but tells no height: {}.", error.message));
    return { .kind = FindingKind::DriverInTheWay,
             .subject = device_subject(info),
             .what = fmt::format("It may be read, but could not be opened: {}.", error.message),
             .remedy = { "Close other programs that use it (a second tractus, OpenTabletDriver, a "
                         "maker's own driver).",
                         "Then unplug it and plug it in again." } };
}

static std::vector<std::string> broken_report_remedy(drivers::DeviceInfo const& info)
{
    if (drivers::is_gpio_encoder(info))
        return {
            "Set the surface to where it was at the beginning, and run tractus calibrate zero.",
            "Where it happens again: shorter and screened wires, 1 nF from each line to "
            "ground, and real-time priority for the station (firmware-notes/encoder.md)."
        };
    if (drivers::is_serial_line(info))
        return { "The baud rate has to be the board's, as in --device /dev/ttyACM0@115200.",
                 "A line has to hold one number: height: 512, or 512. firmware-notes/serial.md has "
                 "sketches that print it." };
    return { "A few are lost packets: try a shorter cable, no hub. "
             "Many: record them, and report it." };
}

static Finding broken_reports(DeviceReading const& reading)
{
    auto what = fmt::format("{} of {} reports are not as they should be; the first: {}.",
                            reading.broken_reports, reading.reports, reading.first_broken);
    if (drivers::is_linak_desk(reading.info))
        return desk_is_lost(reading.info, std::move(what));
    return { .kind = FindingKind::BrokenReports,
             .subject = device_subject(reading.info),
             .what = std::move(what),
             .remedy = broken_report_remedy(reading.info) };
}

std::vector<Finding> diagnose_device(DeviceReading const& reading, Duration listened)
{
    std::vector<Finding> findings;
    diagnose_pen(reading, findings);
    if (reading.broken_reports > 0)
        findings.push_back(broken_reports(reading));
    for (auto const& sentence : reading.height_faults)
        findings.push_back({ .kind = FindingKind::HeightFault,
                             .subject = device_subject(reading.info),
                             .what = sentence,
                             .remedy = { "See firmware-notes/ for its wiring." } });
    if (reading.backward_times > 0)
        findings.push_back({ .kind = FindingKind::ClockJump,
                             .subject = device_subject(reading.info),
                             .what = fmt::format("{} of {} reports are older than the one before "
                                                 "them: the clock that stamped them jumped.",
                                                 reading.backward_times, reading.reports),
                             .remedy = { "Record again with tractus record, which stamps with the "
                                         "monotonic clock." } });
    bool const should_send = reading.description.kind == drivers::DeviceKind::Height;
    if (should_send && reading.reports == 0 && reading.height_faults.empty()
        && listened >= std::chrono::seconds(1))
        findings.push_back(
            { .kind = FindingKind::Silent,
              .subject = device_subject(reading.info),
              .what = fmt::format("Nothing came from it in {:.1f} s.", to_seconds(listened)),
              .remedy = { "Unplug it and plug it in again; then look at its power "
                          "and its firmware." } });
    return findings;
}

std::string newest_line(DeviceReading const& reading)
{
    bool const is_text
        = drivers::is_serial_line(reading.info) || drivers::is_iio_channel(reading.info);
    if (!is_text || !reading.last)
        return {};
    auto const bytes = reading.last->bytes();
    return printable({ reinterpret_cast<char const*>(bytes.data()), bytes.size() });
}

std::vector<Finding> diagnose_together(std::span<DeviceReading const> readings)
{
    std::vector<Finding> findings;
    diagnose_nodes(readings, findings);
    return findings;
}

static Duration clock_time(clockid_t clock)
{
    timespec time {};
    ::clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

ClockReading read_clocks()
{
    return { .monotonic = clock_time(CLOCK_MONOTONIC),
             .boottime = clock_time(CLOCK_BOOTTIME),
             .realtime = clock_time(CLOCK_REALTIME) };
}

std::vector<Finding> diagnose_clocks(ClockReading const& before, ClockReading const& after)
{
    // Tolerance: the clocks cannot be read at exactly the same instant.
    constexpr Duration kTolerance = 200ms;
    auto const passed = after.monotonic - before.monotonic;
    auto const slept = (after.boottime - before.boottime) - passed;
    auto const set = (after.realtime - before.realtime) - (after.boottime - before.boottime);
    std::vector<Finding> findings;
    if (slept > kTolerance)
        findings.push_back(
            { .kind = FindingKind::ClockJump,
              .subject = "the machine",
              .what = fmt::format("It slept for {:.1f} s meanwhile: tablets may have "
                                  "lost their mode.",
                                  to_seconds(slept)),
              .remedy = { "Nothing: devices are opened anew after sleep." } });
    if (std::chrono::abs(set) > kTolerance)
        findings.push_back({ .kind = FindingKind::ClockJump,
                             .subject = "the wall clock",
                             .what = fmt::format("It was set by {:+.1f} s meanwhile. Reports are "
                                                 "stamped with the monotonic clock and do not "
                                                 "mind, but waiting in hidapi's libusb back end "
                                                 "does.",
                                                 to_seconds(set)),
                             .remedy = { "Let it be set slowly: sudo systemctl enable --now "
                                         "systemd-timesyncd" } });
    return findings;
}

} // namespace tractus::diagnosis
