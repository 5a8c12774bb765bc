#include "app/diagnosis/tablet_findings.h"

#include "drivers/reports/device_address.h"
#include "drivers/reports/pen_layout.h"
#include "drivers/reports/report_descriptor.h"
#include "drivers/tablets/tablet_lookup.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <optional>
#include <set>
#include <utility>

namespace tractus::diagnosis {

using namespace std::chrono_literals;

namespace {

// Usage "Mouse" on the Generic Desktop page of the HID Usage Tables.
constexpr drivers::HidUsage kMouse = 0x0001'0002;
// Minimum number of reports by which a device can be judged.
constexpr std::size_t kEnoughReports = 20;
// USB vendor id of KYE, which sells tablets under the name Genius.
constexpr std::uint16_t kKyeVendorId = 0x0458;

// True for tablets by KYE. Its mice and keyboards have the same vendor id but other product ids
// (ids from Linux's drivers/hid/hid-kye.c).
bool is_kye_tablet(std::uint16_t vendor_id, std::uint16_t product_id)
{
    return vendor_id == kKyeVendorId && product_id >= 0x5000 && product_id <= 0x50ff;
}

bool is_in_mouse_collection(drivers::HidReportDescriptor const& descriptor,
                            drivers::HidField const& field)
{
    for (auto collection = field.collection; collection;
         collection = descriptor.collections[*collection].parent)
        if (descriptor.collections[*collection].usage == kMouse)
            return true;
    return false;
}

// Returns the ids of the mouse reports in the device's descriptor; 0 stands for reports without
// ids.
std::set<std::uint8_t> mouse_report_ids(drivers::DeviceInfo const& info)
{
    std::set<std::uint8_t> mouse_ids;
    auto const descriptor = drivers::parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return mouse_ids;
    for (auto const& field : descriptor->fields)
        if (field.kind == drivers::HidReportKind::Input
            && is_in_mouse_collection(*descriptor, field))
            mouse_ids.insert(field.report_id);
    return mouse_ids;
}

// True if all reports received so far are mouse reports.
bool sends_mouse_reports(DeviceReading const& reading)
{
    auto const mouse_ids = mouse_report_ids(reading.info);
    return !mouse_ids.empty()
        && std::all_of(reading.report_ids.begin(), reading.report_ids.end(),
                       [&](auto const& entry) {
                           return mouse_ids.contains(0) || mouse_ids.contains(entry.first);
                       });
}

std::vector<std::string> mouse_mode_remedy(drivers::DeviceInfo const& info)
{
    if (is_kye_tablet(info.vendor_id, info.product_id))
        return {
            "sudo modprobe hid_kye, which switches these tablets; then unplug it and plug it in "
            "again.",
            "If that does not help, another driver has it: sudo modprobe -r hid_generic; sudo "
            "modprobe hid_kye; then plug it in again."
        };
    return { "Unplug it and plug it in again while tractus runs: it is switched when it is opened.",
             "If that does not help: sudo modprobe -r wacom hid_uclogic; then plug it in again.",
             "Or read it past the kernel: --device libusb:BUS-PORTS:INTERFACE" };
}

Finding mouse_mode(drivers::DeviceInfo const& info, std::string what)
{
    return { .kind = FindingKind::MouseMode,
             .subject = device_subject(info),
             .what = std::move(what),
             .remedy = mouse_mode_remedy(info) };
}

Finding pen_is_silent(DeviceReading const& reading)
{
    return { .kind = FindingKind::Silent,
             .subject = device_subject(reading.info),
             .what
             = fmt::format("It sends reports ({} so far), but none of them is of a pen: keys, "
                           "fingers and a mouse on the tablet send some, too.",
                           reading.reports),
             .remedy = { "Bring the pen closer than a centimetre to the surface, and move it.",
                         "If that is what you did, the pen is of another tablet, or its battery is "
                         "empty where it has one." } };
}

// Returns the ids of the pen reports in the device's descriptor; 0 stands for reports without ids.
std::set<std::uint8_t> described_pen_ids(drivers::DeviceInfo const& info)
{
    std::set<std::uint8_t> ids;
    if (auto const descriptor = drivers::parse_report_descriptor(info.report_descriptor))
        for (auto const& layout : drivers::find_pen_layouts(*descriptor))
            ids.insert(layout.report_id);
    return ids;
}

// Returns the time at which a tablet lost its full mode. From that time on it sent only mouse
// reports instead of pen reports, or reports of its descriptor instead of vendor-specific ones. No
// value if the mode was not lost.
std::optional<Timestamp> find_lost_mode(DeviceReading const& reading)
{
    auto const mouse_ids = mouse_report_ids(reading.info);
    auto const pen_ids = described_pen_ids(reading.info);
    if (mouse_ids.contains(0) || pen_ids.contains(0))
        return std::nullopt;
    for (auto const& [before, full] : reading.report_ids)
        for (auto const& [after, lesser] : reading.report_ids) {
            bool const is_lesser = mouse_ids.contains(after)
                || (pen_ids.contains(after) && !pen_ids.contains(before));
            if (full.samples >= kEnoughReports && lesser.reports >= kEnoughReports && is_lesser
                && !mouse_ids.contains(before) && full.last < lesser.first)
                return lesser.first;
        }
    return std::nullopt;
}

std::string lost_mode_sentence(Timestamp when)
{
    return fmt::format(
        "At {:.1f} s it lost its full mode: from then on it sends reports of the mode "
        "that it has when it is plugged in.",
        to_seconds(when));
}

// Returns the pressure that a share of the touching samples do not exceed. No value if the device
// reports no pressure.
std::optional<double> pressure_quantile(PenReading const& pen, double share)
{
    std::size_t below = 0;
    for (std::size_t step = 0; step < pen.pressures.size(); ++step) {
        below += pen.pressures[step];
        if (static_cast<double>(below) >= share * static_cast<double>(pen.touching))
            return static_cast<double>(step + 1) / PenReading::kPressureSteps;
    }
    return std::nullopt;
}

// Reports a worn tip that always presses a little. A drawing hand lifts the pen now and then; every
// public recording of a touching pen (DIGImend, hid-devices) contains hovering samples.
void diagnose_tip(DeviceReading const& reading, std::vector<Finding>& findings)
{
    constexpr std::size_t kEnoughSamples = 100;
    // Minimum share of the time during which a drawing hand lifts the pen.
    constexpr double kLiftedShare = 0.1;
    // Above this pressure, as a share of the full one, the pen may really have touched all the
    // time.
    constexpr double kLightPressure = 0.25;
    // Proposed threshold as a multiple of the tip's false pressure. It must exceed 2, as the pen
    // draws until the pressure falls to half the threshold.
    constexpr double kMargin = 2.5;
    auto const& pen = reading.pen;
    auto const leak = pressure_quantile(pen, kLiftedShare);
    if (pen.hovering > 0 || pen.touching < kEnoughSamples || !leak || *leak > kLightPressure)
        return;
    auto const threshold = std::ceil(*leak * kMargin * 100) / 100;
    findings.push_back(
        { .kind = FindingKind::PenNeverLifts,
          .subject = device_subject(reading.info),
          .what = fmt::format("The pen never lifts: all of its {} samples touch, many with no more "
                              "than {:.0f} % of the full pressure. Its tip presses by itself.",
                              pen.touching, *leak * 100),
          .remedy = {
              fmt::format("Write into the rig: pressure_threshold = {:.2f}", threshold),
              "Then it draws above that pressure, and until half of it. Hold the pen near the "
              "surface without touching it, and run tractus doctor again.",
              "Another nib, or one pushed in firmly, often ends it.",
          } });
}

std::string tablet_path(drivers::DeviceInfo const& info)
{
    return info.physical_path.substr(0, info.physical_path.rfind("/input"));
}

bool are_one_tablet(DeviceReading const& a, DeviceReading const& b)
{
    return a.info.bus == b.info.bus && a.info.vendor_id == b.info.vendor_id
        && a.info.product_id == b.info.product_id && a.info.serial_number == b.info.serial_number
        && tablet_path(a.info) == tablet_path(b.info);
}

bool is_same_touch(PenTouch const& a, PenTouch const& b)
{
    constexpr Duration kMaxApart = 60ms;
    constexpr double kNear = 0.02; // Tolerance of positions, as a share of the active area's sides.
    auto const is_near = [](Vec2 const& first, Vec2 const& second) {
        return (first - second).cwiseAbs().maxCoeff() <= kNear;
    };
    return std::chrono::abs(a.begin - b.begin) <= kMaxApart
        && std::chrono::abs(a.end - b.end) <= kMaxApart && is_near(a.begin_place, b.begin_place)
        && is_near(a.end_place, b.end_place);
}

bool sends_the_same(PenReading const& a, PenReading const& b)
{
    constexpr double kMaxOf = 0.8;
    bool const is_a_fewer = a.touches.size() <= b.touches.size();
    auto const& fewer = is_a_fewer ? a.touches : b.touches;
    auto const& more = is_a_fewer ? b.touches : a.touches;
    auto const same = std::ranges::count_if(fewer, [&](PenTouch const& touch) {
        return std::ranges::any_of(
            more, [&](PenTouch const& other) { return is_same_touch(touch, other); });
    });
    return same > 0 && static_cast<double>(same) >= kMaxOf * static_cast<double>(fewer.size());
}

// True if a device node with reports of the tablet's basic mode replaced the node of its full mode,
// for the rest of the observation.
bool takes_over(DeviceReading const& lesser, DeviceReading const& full)
{
    if (full.samples < kEnoughReports || lesser.reports < kEnoughReports || !full.last_sample
        || !described_pen_ids(full.info).empty())
        return false;
    bool const is_lesser = sends_mouse_reports(lesser) || lesser.samples >= kEnoughReports;
    return is_lesser && std::ranges::all_of(lesser.report_ids, [&](auto const& entry) {
               return entry.second.first > *full.last_sample;
           });
}

} // namespace

std::string device_subject(drivers::DeviceInfo const& info)
{
    return fmt::format("{} ({:04x}:{:04x}) at {}", info.name.empty() ? "a device" : info.name,
                       info.vendor_id, info.product_id, info.location);
}

// True if the vendor id belongs to a maker of tablets. Ids of chip makers, which some tablets use,
// do not count, as their chips are also in other kinds of devices.
bool is_tablet(std::uint16_t vendor_id, std::uint16_t product_id)
{
    static std::set<std::uint16_t> const makers = [] {
        std::set<std::uint16_t> ids;
        for (auto const& tablet : drivers::known_tablets())
            for (auto const& identifier : tablet.identifiers)
                ids.insert(identifier.vendor_id);
        constexpr std::uint16_t kStMicroelectronics = 0x0483;
        constexpr std::uint16_t kCambridgeSiliconRadio = 0x0a12;
        ids.erase(kStMicroelectronics);
        ids.erase(kCambridgeSiliconRadio);
        ids.erase(kKyeVendorId);
        return ids;
    }();
    return makers.contains(vendor_id) || is_kye_tablet(vendor_id, product_id)
        || drivers::find_tablet({ .vendor_id = vendor_id, .product_id = product_id }).has_value();
}

// Explains what must be known about an unsupported tablet to support it.
std::vector<std::string> describe_needed_information(drivers::DeviceInfo const& info)
{
    // The location of a recorded device is not an address.
    auto const address = drivers::parse_device_address(info.location) ? info.location : "DEVICE";
    return {
        "A pen's report has to hold: x and y (16 or 24 bits each), pressure (8 to 16 bits), and",
        "bits for \"in range\", \"tip\" and each button; often tilt (two signed bytes) as well.",
        fmt::format("See whether its bytes change with the pen: tractus watch {}", address),
        "Record it, so that its format can be added: draw a slow line along each edge, press from",
        "light to hard, tilt the pen, press each button, turn the pen over, lift it:",
        fmt::format("tractus record -o my-tablet.tractus-log --seconds 30 --device {}", address),
        "Try its other nodes, too: tractus devices",
    };
}

void diagnose_pen(DeviceReading const& reading, std::vector<Finding>& findings)
{
    auto const& info = reading.info;
    bool const is_kye = is_kye_tablet(info.vendor_id, info.product_id);
    bool const known = is_tablet(info.vendor_id, info.product_id);
    bool const is_pen = reading.description.kind == drivers::DeviceKind::Pen;
    if (reading.reports < kEnoughReports || (!is_pen && !known))
        return;
    // A mouse with tip pressure is treated as a pen. Genius tablets in mouse mode omit most of
    // their reports, so their samples do not count.
    if (sends_mouse_reports(reading) && (reading.samples == 0 || is_kye))
        findings.push_back(mouse_mode(info,
                                      fmt::format("All of its {} reports are a mouse's: the tablet "
                                                  "has not been switched to its full mode, or has "
                                                  "lost it.",
                                                  reading.reports)));
    else if (auto const lost = find_lost_mode(reading))
        findings.push_back(mouse_mode(info, lost_mode_sentence(*lost)));
    else if (reading.samples > 0)
        diagnose_tip(reading, findings);
    else if (is_pen)
        findings.push_back(pen_is_silent(reading));
    else
        findings.push_back({ .kind = FindingKind::UnknownTablet,
                             .subject = device_subject(info),
                             .what = fmt::format("It sends reports ({} so far), but none of them "
                                                 "is a pen's as we know it.",
                                                 reading.reports),
                             .remedy = describe_needed_information(info) });
}

void diagnose_nodes(std::span<DeviceReading const> readings, std::vector<Finding>& findings)
{
    for (std::size_t i = 0; i < readings.size(); ++i)
        for (std::size_t j = 0; j < readings.size(); ++j) {
            auto const& first = readings[i];
            auto const& second = readings[j];
            if (i == j || !are_one_tablet(first, second))
                continue;
            if (takes_over(second, first))
                findings.push_back(mouse_mode(first.info, lost_mode_sentence(*first.last_sample)));
            if (i < j && sends_the_same(first.pen, second.pen))
                findings.push_back(
                    { .kind = FindingKind::SentTwice,
                      .subject = device_subject(first.info),
                      .what
                      = fmt::format("Each touch comes twice, at the same time and place: here "
                                    "and at {}.",
                                    second.info.location),
                      .remedy = { fmt::format("Read one of the two alone: --device {}",
                                              first.info.location),
                                  "Or stop another tablet program that makes a second pen of it "
                                  "(OpenTabletDriver, a maker's own driver)." } });
        }
}

} // namespace tractus::diagnosis
