#include "app/commands/decode.h"

#include "app/options/recordings_help.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "drivers/device_kind.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tractus::commands {

namespace {

constexpr std::size_t kChunkBytes = std::size_t { 1 } << 16;

struct Options {
    std::string log;
    std::string output;
    bool csv = false;
    bool raw = false;
};

using Sink = std::function<Result<void>(std::string_view)>;

// Maximum number of intervals kept per device, enough for a representative median.
constexpr std::size_t kMaxIntervals = 50'000;

// Decoder of one device of the log, and statistics of the device's reports.
struct Device {
    std::unique_ptr<drivers::PenDecoder> pen {}; // Null if the device is not a pen.
    drivers::PenSilence silence {};
    std::size_t reports = 0;
    std::size_t samples = 0;
    std::size_t touching = 0;
    std::size_t strokes = 0;
    bool was_touching = false;
    // Times between successive pen samples, up to kMaxIntervals of them.
    std::vector<Duration> intervals {};
    Timestamp last {};
    std::size_t bad_reports = 0;
    std::string first_problem {};
};

void append_integer(std::string& text, std::int64_t value)
{
    char digits[24];
    auto const end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
    text.append(digits, end);
}

// Appends a number with fixed decimals, several times faster than printf. The absolute value must
// be below 1e12.
void append_fixed(std::string& text, double value, int decimals)
{
    static constexpr std::int64_t kPowers[] = { 1, 10, 100, 1'000, 10'000, 100'000, 1'000'000 };
    auto const power = kPowers[decimals];
    auto const scaled = std::llround(value * static_cast<double>(power));
    if (scaled < 0)
        text += '-';
    append_integer(text, std::abs(scaled) / power);
    text += '.';
    auto fraction = std::abs(scaled) % power;
    auto const begin = text.size();
    text.append(static_cast<std::size_t>(decimals), '0');
    for (auto i = text.size(); i-- > begin; fraction /= 10)
        text[i] = static_cast<char>('0' + fraction % 10);
}

void append_flag(std::string& text, bool is_known, bool value)
{
    text += ',';
    if (is_known)
        text += value ? '1' : '0';
}

void append_row(std::string& text, std::size_t device, drivers::PenSample const& sample,
                drivers::PenTraits const& traits, bool raw)
{
    append_fixed(text, to_seconds(sample.time), 6);
    text += ',';
    append_integer(text, static_cast<std::int64_t>(device));
    text += ',';
    append_fixed(text, sample.position_mm.x(), 4);
    text += ',';
    append_fixed(text, sample.position_mm.y(), 4);
    text += ',';
    if (sample.pressure)
        append_fixed(text, *sample.pressure, 5);
    for (int axis = 0; axis < 2; ++axis) {
        text += ',';
        if (sample.tilt_rad)
            append_fixed(text, degrees((*sample.tilt_rad)[axis]), 2);
    }
    append_flag(text, traits.has_in_range, sample.in_range);
    append_flag(text, true, sample.touching && !sample.eraser);
    append_flag(text, traits.has_eraser, sample.touching && sample.eraser);
    text += ',';
    if (traits.button_count > 0)
        append_integer(text, sample.buttons);
    if (raw) {
        for (auto const value : { sample.raw_x, sample.raw_y }) {
            text += ',';
            append_integer(text, value);
        }
        text += ',';
        if (sample.pressure)
            append_integer(text, sample.raw_pressure);
    }
    text += '\n';
}

void count(Device& device, drivers::PenSample const& sample)
{
    if (device.samples++ > 0 && device.intervals.size() < kMaxIntervals)
        device.intervals.push_back(sample.time - device.last);
    device.last = sample.time;
    device.touching += sample.touching;
    device.strokes += sample.touching && !device.was_touching;
    device.was_touching = sample.touching;
}

// Passes every report of a pen to its decoder, in the log's order, and the decoded samples to
// `use`. Returns the time from the earliest to the latest report of all devices.
Result<Duration>
decode_all(drivers::Log const& log, std::vector<Device>& devices,
           std::function<Result<void>(std::size_t, drivers::PenSample const&)> const& use)
{
    auto earliest = log.begin();
    auto latest = log.begin();
    std::vector<drivers::PenSample> samples;
    drivers::LogCursor cursor(log);
    while (auto const* const report = TRY(cursor.next())) {
        earliest = std::min(earliest, report->time);
        latest = std::max(latest, report->time);
        auto& device = devices[report->device];
        bool const went_away = report->bytes.empty();
        device.reports += !went_away;
        if (!device.pen)
            continue;
        if (auto const gone = went_away
                ? device.pen->leave(report->time)
                : device.silence.leave_after_silence(*device.pen, report->time))
            TRY(use(report->device, *gone));
        if (went_away)
            continue;
        samples.clear();
        auto const decoded = device.pen->decode(report->time, report->bytes, samples);
        if (!decoded && device.bad_reports++ == 0)
            device.first_problem
                = fmt::format("at {:.6f} s: {}", to_seconds(report->time), decoded.error().message);
        for (auto const& sample : samples) {
            device.silence.heard(sample);
            TRY(use(report->device, sample));
        }
    }
    return latest - earliest;
}

// Returns the log's pens. Prints a message about each other device on standard error. Fails if
// there is no pen.
Result<std::vector<Device>> find_pens(drivers::Log const& log)
{
    std::vector<Device> devices;
    std::string reasons;
    for (auto const& info : log.devices) {
        auto& device = devices.emplace_back();
        auto const index = devices.size() - 1;
        if (auto pen = drivers::make_pen_decoder(info))
            device.pen = std::move(*pen);
        else if (!drivers::make_height_decoder(info))
            reasons += fmt::format("{}device {}: {}", reasons.empty() ? "" : "; ", index,
                                   pen.error().message);
    }
    if (std::none_of(devices.begin(), devices.end(),
                     [](auto const& device) { return device.pen != nullptr; }))
        return fail(Fault::User,
                    fmt::format("there is no pen to decode in {}: {}", log.name,
                                reasons.empty() ? "it has a height sensor alone" : reasons));
    if (!reasons.empty())
        terminal::print_warning(fmt::format("{}: {}", log.name, reasons));
    return devices;
}

// Reports for each device what could not be decoded. Fails if nothing could be decoded.
Result<void> report_problems(drivers::Log const& log, std::vector<Device> const& devices)
{
    if (auto const warnings = drivers::summarize_warnings(log); !warnings.empty())
        terminal::print_warning(warnings);
    for (std::size_t i = 0; i < devices.size(); ++i) {
        auto const& device = devices[i];
        if (device.bad_reports == 0)
            continue;
        auto const& where = log.devices[i].location;
        if (device.bad_reports == device.reports)
            return fail(
                Fault::Device,
                fmt::format("{}: its reports are not what its report descriptor says, the first {}",
                            where, device.first_problem));
        terminal::print_warning(
            fmt::format("{}: {} of {} reports could not be decoded, the first {}", where,
                        device.bad_reports, device.reports, device.first_problem));
    }
    return {};
}

Result<void> write_csv(drivers::Log const& log, bool raw, Sink const& sink)
{
    auto devices = TRY(find_pens(log));
    std::string text
        = "time_s,device,x_mm,y_mm,pressure,tilt_x_deg,tilt_y_deg,in_range,tip,eraser,buttons";
    text += raw ? ",x_raw,y_raw,pressure_raw\n" : "\n";
    auto const add_row = [&](std::size_t device, drivers::PenSample const& sample) -> Result<void> {
        append_row(text, device, sample, devices[device].pen->traits(), raw);
        if (text.size() < kChunkBytes)
            return {};
        TRY(sink(text));
        text.clear();
        return {};
    };
    TRY(decode_all(log, devices, add_row));
    TRY(report_problems(log, devices));
    return sink(text);
}

// Describes the median rate as ", typically 200 per second", or returns an empty text if it is
// unknown. Pauses of the pen hardly affect the median.
std::string describe_rate(std::vector<Duration> intervals)
{
    if (intervals.empty())
        return {};
    auto const middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    if (middle->count() <= 0)
        return {};
    return fmt::format(", typically {:.0f} per second", 1 / to_seconds(*middle));
}

Result<void> print_summary(drivers::Log const& log)
{
    auto devices = TRY(find_pens(log));
    auto const duration = TRY(decode_all(
        log, devices, [&](std::size_t device, drivers::PenSample const& sample) -> Result<void> {
            count(devices[device], sample);
            return {};
        }));
    auto text = fmt::format("{}: {} reports in {:.3f} s\n", log.name, log.record_count(),
                            to_seconds(duration));
    for (std::size_t i = 0; i < devices.size(); ++i) {
        auto const& device = devices[i];
        auto const& info = log.devices[i];
        text += fmt::format("device {}: {} ({:04x}:{:04x}), {} reports\n  {}\n", i, info.name,
                            info.vendor_id, info.product_id, device.reports,
                            drivers::describe_device(info).text);
        if (device.pen)
            text
                += fmt::format("  {} samples{}, {} of them touching; strokes: {}\n", device.samples,
                               describe_rate(device.intervals), device.touching, device.strokes);
    }
    if (!log.tools.empty())
        text += fmt::format("{} changes of tool\n", log.tools.size());
    if (!log.rig_text.empty())
        text += "the rig's calibration is in the log\n";
    TRY(report_problems(log, devices));
    return terminal::print_out(text);
}

Result<void> run(Options const& options)
{
    if (!options.output.empty())
        TRY(check_writable(options.output));
    auto const log = TRY(drivers::read_log(options.log));
    if (!options.csv)
        return print_summary(log);
    if (options.output.empty())
        return write_csv(log, options.raw, terminal::print_out);
    if (std::error_code ignored; std::filesystem::equivalent(options.log, options.output, ignored))
        return fail(
            Fault::User,
            fmt::format("{} is the log itself: choose another name for the CSV", options.output));
    return write_file(options.output, [&](std::ostream& out) {
        return write_csv(log, options.raw, [&](std::string_view text) -> Result<void> {
            out.write(text.data(), static_cast<std::streamsize>(text.size()));
            return {};
        });
    });
}

} // namespace

void add_decode_command(CLI::App& root, options::Action& action)
{
    auto* const command = root.add_subcommand("decode", "Show what the pens in a device log did");
    command->footer(
        "Without --csv, a summary is printed.\n"
        "\n"
        "CSV has one row per pen sample. Positions are in millimetres from the lower left\n"
        "corner of the tablet's active area, y away from the user; tilts in degrees towards\n"
        "+x and +y; tip and eraser are 1 while that end of the pen touches; buttons is a sum\n"
        "of 1, 2 and 4 for the first, second and third barrel button. A field is empty where\n"
        "the device does not say. --raw adds the counts as the device reports them, y\n"
        "downwards.");
    // Shared by the parser's options and the command's action.
    auto options = std::make_shared<Options>();
    command->add_option("LOG", options->log, fmt::format("A recording: {}", options::kRecordings))
        ->required();
    auto* const csv = command->add_flag("--csv", options->csv, "Print one row per pen sample");
    command->add_flag("--raw", options->raw, "Add the device's own counts to each row")->needs(csv);
    command
        ->add_option("-o,--output", options->output,
                     "Write to this file in place of standard output")
        ->type_name("FILE")
        ->needs(csv);
    command->callback([&action, options] { action = [options] { return run(*options); }; });
}

} // namespace tractus::commands
