#include "app/commands/doctor.h"

#include "app/commands/device_sources.h"
#include "app/devices/live_devices.h"
#include "app/diagnosis/diagnose.h"
#include "app/diagnosis/udev_rules.h"
#include "app/files/user_folder.h"
#include "app/options/checks.h"
#include "app/options/recordings_help.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/terminal/terminal.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/file.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fmt/core.h>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace tractus::commands {

namespace {

struct DoctorArguments {
    std::vector<std::string> devices;
    std::string log;
    double seconds = 3;
    bool as_json = false;
    bool install_rules = false;
    bool for_group = false;
    std::string surface; // Width and depth of the active area in millimetres, such as "254x159".
    std::string rig_file = files::user_rig_path().string();
    std::string rules_file = "/etc/udev/rules.d/70-tractus.rules";
};

void append(std::vector<diagnosis::Finding>& all, std::vector<diagnosis::Finding> some)
{
    for (auto& finding : some)
        all.push_back(std::move(finding));
}

diagnosis::Finding all_is_well(diagnosis::DeviceReading const& reading)
{
    diagnosis::Finding finding {
        .kind = diagnosis::FindingKind::Fine,
        .subject = fmt::format("{} at {}", reading.info.name, reading.info.location),
        .what = fmt::format("{}; {} reports, {:.0f} per second.", reading.description.text,
                            reading.reports, reading.pace.rate_hz)
    };
    if (auto const line = diagnosis::newest_line(reading); !line.empty())
        finding.what += fmt::format(" The newest line: \"{}\".", line);
    auto const pen = drivers::make_pen_decoder(reading.info);
    finding.lacks_size = pen && (*pen)->traits().is_size_assumed;
    if (finding.lacks_size)
        finding.remedy = {
            "Its size is a guess: measure the two sides of its active area, and tell them with",
            "tractus doctor --surface WIDTHxDEPTH --rig FILE",
        };
    return finding;
}

// True if the device is a tablet's additional device, for keys or fingers, while another device of
// the same USB ids carries the pen.
bool is_beside_a_pen(diagnosis::DeviceReading const& reading,
                     std::vector<diagnosis::DeviceReading> const& all)
{
    return reading.description.kind == drivers::DeviceKind::Other
        && std::any_of(all.begin(), all.end(), [&](diagnosis::DeviceReading const& other) {
               return other.description.kind == drivers::DeviceKind::Pen
                   && other.info.vendor_id == reading.info.vendor_id
                   && other.info.product_id == reading.info.product_id;
           });
}

void judge(std::vector<diagnosis::DeviceMonitor> const& monitors, Duration listened,
           std::vector<diagnosis::Finding>& findings)
{
    std::vector<diagnosis::DeviceReading> readings;
    for (auto const& monitor : monitors)
        readings.push_back(monitor.reading());
    for (auto const& reading : readings) {
        if (is_beside_a_pen(reading, readings))
            continue;
        auto found = diagnosis::diagnose_device(reading, listened);
        if (found.empty() && reading.description.kind != drivers::DeviceKind::Other)
            found.push_back(all_is_well(reading));
        append(findings, std::move(found));
    }
    append(findings, diagnosis::diagnose_together(readings));
}

// Listens to the devices for `seconds` while the user moves the pen, and adds findings about them.
Result<void> listen(devices::LiveDevices& devices, double seconds,
                    std::vector<diagnosis::Finding>& findings)
{
    std::vector<diagnosis::DeviceMonitor> monitors;
    for (auto const& info : devices.infos())
        monitors.emplace_back(info);
    auto const before = diagnosis::read_clocks();
    auto const& stop = stop_on_signals();
    std::vector<devices::LiveReport> reports;
    Duration listened {};
    while (!stop && devices.any_left() && to_seconds(listened) < seconds) {
        devices.take(reports);
        for (auto const& [device, report] : reports)
            monitors[device].push(report);
        auto const now = diagnosis::read_clocks().monotonic;
        listened = now - before.monotonic;
        for (auto& monitor : monitors)
            monitor.pass_time(Timestamp(now));
        if (reports.empty())
            std::this_thread::sleep_for(devices::kPollRest);
    }
    append(findings, diagnosis::diagnose_clocks(before, diagnosis::read_clocks()));
    judge(monitors, listened, findings);
    return {};
}

// Examines the machine, and those of its devices that can be opened.
Result<void> examine_machine(DoctorArguments const& arguments,
                             std::vector<diagnosis::Finding>& findings)
{
    auto const facts = diagnosis::gather_system_facts();
    append(findings, diagnosis::diagnose_system(facts));
    std::vector<drivers::DeviceInfo> usable;
    for (auto const& device : facts.devices)
        if (device.description.kind != drivers::DeviceKind::Other && device.open_error == 0)
            usable.push_back(device.info);
    if (usable.empty())
        return {};
    terminal::print_error(
        fmt::format("Listening for {:g} s: move the pen over the tablet, press it, and "
                    "move the surface.\n",
                    arguments.seconds));
    std::vector<devices::RefusedDevice> refused;
    auto devices = devices::LiveDevices::open_usable(usable, refused);
    for (auto const& [info, error] : refused)
        findings.push_back(diagnosis::diagnose_refusal(info, error));
    return listen(devices, arguments.seconds, findings);
}

Result<void> examine_log(std::string const& path, std::vector<diagnosis::Finding>& findings)
{
    auto const log = TRY(drivers::read_log(path));
    if (auto const odd = drivers::summarize_warnings(log); !odd.empty())
        terminal::print_warning(odd);
    std::vector<diagnosis::DeviceMonitor> monitors;
    for (auto const& info : log.devices)
        monitors.emplace_back(info);
    drivers::RawReport report;
    drivers::LogCursor cursor(log);
    while (auto const* const from = TRY(cursor.next())) {
        report.received = from->time;
        report.size = from->bytes.size();
        std::ranges::copy(from->bytes, report.storage.begin());
        monitors[from->device].push(report);
    }
    if (!log.empty())
        for (auto& monitor : monitors)
            monitor.pass_time(log.end());
    judge(monitors, log.end() - log.begin(), findings);
    return {};
}

Result<void> install_rules(DoctorArguments const& arguments)
{
    TRY(write_file(arguments.rules_file,
                   diagnosis::udev_rules(arguments.for_group ? diagnosis::RuleHolder::Group
                                                             : diagnosis::RuleHolder::Seat)));
    return terminal::print_out(fmt::format(
        "{} is written. Now, as root:\n"
        "  udevadm control --reload-rules && udevadm trigger\n"
        "or unplug the devices and plug them in again.\n{}",
        arguments.rules_file,
        arguments.for_group ? "Who may use them: sudo adduser USER plugdev, then log in "
                              "again.\n"
                            : ""));
}

// Parses two sides in millimetres, such as "254x158.75".
std::optional<Vec2> parse_sides(std::string_view text)
{
    Vec2 sides_mm;
    auto const* const end = text.data() + text.size();
    auto const [x, error] = std::from_chars(text.data(), end, sides_mm.x());
    if (error != std::errc() || x == end || *x != 'x')
        return std::nullopt;
    auto const [rest, y_error] = std::from_chars(x + 1, end, sides_mm.y());
    bool const is_whole = y_error == std::errc() && rest == end;
    return is_whole && calib::is_tablet_area(sides_mm) ? std::optional(sides_mm) : std::nullopt;
}

std::string expected_sides()
{
    return fmt::format("expected the two sides of the tablet's active area in millimetres, such as "
                       "254x158.8, each {} to {}",
                       calib::kMinSurfaceSide_mm, calib::kMaxSurfaceSide_mm);
}

// Saves the size of the active area, as the user measured it, in the rig's file.
Result<void> write_sides(calib::Rig rig, Vec2 const& sides_mm, std::string const& rig_file)
{
    rig.tablet_size_mm = rig.surface_mm.emplace(sides_mm);
    TRY(calib::save_rig(rig, rig_file));
    return terminal::print_out(fmt::format("{}: the tablet's surface is {:g} x {:g} mm\n", rig_file,
                                           sides_mm.x(), sides_mm.y()));
}

Result<void> measure_surface(DoctorArguments const& arguments)
{
    auto const sides_mm = parse_sides(arguments.surface);
    if (!sides_mm)
        return fail(Fault::User,
                    fmt::format("--surface \"{}\": {}", arguments.surface, expected_sides()));
    return write_sides(TRY(calib::load_rig(arguments.rig_file)), *sides_mm, arguments.rig_file);
}

// Asks the user at the terminal for the size of a tablet that does not report it, until the answer
// is valid or empty. Does nothing if there is no rig file, or if the rig has the size already.
Result<void> ask_for_sides(std::string const& tablet, std::string const& rig_file)
{
    std::error_code ignored;
    if (rig_file.empty() || !std::filesystem::exists(rig_file, ignored))
        return {};
    auto const rig = TRY(calib::load_rig(rig_file));
    if (rig.surface_mm)
        return {};
    TRY(terminal::print_out(
        fmt::format("\n{} does not tell the size of its surface. Measure the sides of its "
                    "active area.\nWidth x depth in millimetres, such as 254x158.8 "
                    "(nothing: leave it as it is): ",
                    tablet)));
    for (std::string line; std::getline(std::cin, line) && !line.empty();) {
        if (auto const sides_mm = parse_sides(line))
            return write_sides(rig, *sides_mm, rig_file);
        TRY(terminal::print_out(fmt::format("\"{}\": {}: ", line, expected_sides())));
    }
    return {};
}

Result<void> print(DoctorArguments const& arguments,
                   std::vector<diagnosis::Finding> const& findings)
{
    if (arguments.as_json)
        return terminal::print_out(diagnosis::print_findings_json(findings));
    TRY(terminal::print_out(diagnosis::print_findings(findings)));
    auto const unmeasured = std::ranges::find_if(findings, &diagnosis::Finding::lacks_size);
    if (unmeasured == findings.end() || !terminal::is_terminal())
        return {};
    return ask_for_sides(unmeasured->subject, arguments.rig_file);
}

Result<void> run(DoctorArguments const& arguments)
{
    if (!arguments.surface.empty())
        return measure_surface(arguments);
    if (arguments.install_rules)
        return install_rules(arguments);
    std::vector<diagnosis::Finding> findings;
    if (!arguments.log.empty()) {
        TRY(examine_log(arguments.log, findings));
    } else if (!arguments.devices.empty()) {
        auto devices = TRY(devices::LiveDevices::open_named(arguments.devices));
        TRY(listen(devices, arguments.seconds, findings));
    } else {
        TRY(examine_machine(arguments, findings));
    }
    TRY(print(arguments, findings));
    if (!diagnosis::has_trouble(findings))
        return {};
    auto const count = std::ranges::count_if(
        findings, [](auto const& finding) { return finding.kind != diagnosis::FindingKind::Fine; });
    return fail(Fault::User,
                fmt::format("{} {} found, with the remedy for each", count,
                            count == 1 ? "problem was" : "problems were"));
}

} // namespace

void add_doctor_command(CLI::App& root, options::Action& action)
{
    auto arguments = std::make_shared<DoctorArguments>();
    auto* const command = root.add_subcommand(
        "doctor", "Find out why a tablet or sensor does not work, and what to do about it");
    auto* const log = command->add_option("LOG", arguments->log,
                                          fmt::format("A recording to examine in place of the "
                                                      "machine: {}",
                                                      options::kRecordings));
    auto* const device
        = command
              ->add_option("--device", arguments->devices,
                           fmt::format("What to listen to, each {}; without it, everything",
                                       devices::device_name_help()))
              ->type_name("DEVICE...")
              ->excludes(log);
    command->add_option("--seconds", arguments->seconds, "How long to listen")
        ->type_name("SECONDS")
        ->check(options::number(0, 3600))
        ->capture_default_str();
    command->add_flag("--json", arguments->as_json, "Print a JSON array");
    auto* const install
        = command
              ->add_flag("--install-rules", arguments->install_rules,
                         "Write the udev rules that permit the devices to whoever sits at the "
                         "screen")
              ->excludes(log, device);
    command
        ->add_flag("--for-group", arguments->for_group,
                   "Permit them to the group plugdev in place, for users over ssh")
        ->needs(install);
    command->add_option("--rules-file", arguments->rules_file, "Where the rules are written")
        ->type_name("FILE")
        ->capture_default_str()
        ->needs(install);
    command
        ->add_option("--surface", arguments->surface,
                     "Write the two sides of the tablet's active area, in millimetres, into the "
                     "rig: for tablets that do not tell them")
        ->type_name("WIDTHxDEPTH")
        ->excludes(log, device, install);
    command
        ->add_option("--rig", arguments->rig_file,
                     "The rig that keeps the sides of the tablet's active area; without it, "
                     "your own")
        ->type_name("FILE")
        ->excludes(install);
    command->footer(
        "Looks at nodes and permissions, at the kernel's drivers and at libraries; then\n"
        "listens for tablets in mouse mode or with unknown reports, for a sensor on a rail,\n"
        "stuck, jumping or silent, for a pen that never lifts, and for clocks that jump. Each\n"
        "finding comes with its remedy. Exits with 1 if it found a problem.");
    command->callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

} // namespace tractus::commands
