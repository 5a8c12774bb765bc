#include "app/verbs/convert.h"

#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/verbs/checks.h"
#include "drivers/file.h"
#include "drivers/foreign_log.h"
#include "drivers/log_writer.h"

#include <charconv>
#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

namespace {

namespace fs = std::filesystem;

constexpr char const* kHidRecorder = "hid-recorder";
constexpr char const* kTractusLog = "tractus-log";

struct ConvertArguments {
    fs::path input;
    fs::path output;
    std::string format; // Empty: as the output's name says.
    std::string ids;
};

// "256c:006e" → both numbers.
std::optional<std::pair<std::uint16_t, std::uint16_t>> parse_ids(std::string const& text)
{
    auto const number = [](std::string const& digits) -> std::optional<std::uint16_t> {
        std::uint16_t value = 0;
        auto const* const end = digits.data() + digits.size();
        auto const result = std::from_chars(digits.data(), end, value, 16);
        return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
    };
    auto const colon = text.find(':');
    if (colon == std::string::npos)
        return std::nullopt;
    auto const vendor = number(text.substr(0, colon));
    auto const product = number(text.substr(colon + 1));
    if (!vendor || !product)
        return std::nullopt;
    return std::pair(*vendor, *product);
}

CLI::Validator device_ids()
{
    return { [](std::string const& text) {
                return parse_ids(text)
                    ? std::string()
                    : fmt::format("'{}' is not VENDOR:PRODUCT in hexadecimal, such as 256c:006e",
                                  text);
            },
             "" };
}

// hid-recorder knows HID devices alone, and of them no more than name, path and ids. Where each of
// the log's devices has gone; no value for those that stay behind.
std::vector<std::optional<std::size_t>> keep_what_hid_recorder_knows(LogHeader& header)
{
    std::vector<std::optional<std::size_t>> places;
    std::vector<DeviceInfo> kept;
    for (auto& info : header.devices) {
        if (info.report_descriptor.empty()) {
            places.push_back(std::nullopt);
            continue;
        }
        info.manufacturer.clear();
        info.serial_number.clear();
        info.strings.clear();
        places.push_back(kept.size());
        kept.push_back(std::move(info));
    }
    header.devices = std::move(kept);
    header.rig_text.clear();
    return places;
}

Result<void> write_hid_recorder(std::ostream& out, Log const& log)
{
    LogHeader header { .devices = log.devices };
    auto const places = keep_what_hid_recorder_knows(header);
    if (header.devices.empty())
        return fail(Fault::User,
                    fmt::format("{} has no device with a report descriptor, which hid-recorder's "
                                "format needs: convert it to a .tractus-log",
                                log.name));
    LogWriter writer(out, header);
    LogCursor cursor(log);
    while (auto const* const report = TRY(cursor.next()))
        if (auto const place = places[report->device]; place && !report->bytes.empty())
            writer.write_report(*place, report->time, report->bytes);
    return writer.flush();
}

Result<void> write_tractus_log(std::ostream& out, Log const& log)
{
    LogWriter writer(out, { .devices = log.devices, .rig_text = log.rig_text });
    std::size_t tool = 0;
    auto const write_tools_until = [&](std::size_t position) {
        for (; tool < log.tools.size() && log.tools[tool].position <= position; ++tool)
            writer.write_tool(log.tools[tool].time, log.tools[tool].tool,
                              log.tools[tool].arguments);
    };
    LogCursor cursor(log);
    write_tools_until(0);
    while (auto const* const report = TRY(cursor.next())) {
        writer.write_report(report->device, report->time, report->bytes);
        write_tools_until(cursor.position());
    }
    return writer.flush();
}

Result<void> convert(ConvertArguments const& arguments)
{
    std::error_code ignored;
    if (fs::equivalent(arguments.input, arguments.output, ignored))
        return fail(Fault::User,
                    fmt::format("{} is the recording itself: choose another name for the output",
                                arguments.output.string()));
    TRY(check_writable(arguments.output));
    auto log = TRY(read_any_log(arguments.input));
    if (auto const ids = parse_ids(arguments.ids))
        for (auto& info : log.devices) {
            info.vendor_id = ids->first;
            info.product_id = ids->second;
        }
    if (auto const warnings = summarize_warnings(log); !warnings.empty())
        print_warning(warnings);
    bool const is_ours = arguments.format.empty() ? arguments.output.extension() == ".tractus-log"
                                                  : arguments.format == kTractusLog;
    TRY(write_file(arguments.output, [&](std::ostream& out) {
        return is_ours ? write_tractus_log(out, log) : write_hid_recorder(out, log);
    }));
    return print_out(fmt::format("{}: {} reports of {} device{} as {}\n", arguments.output.string(),
                                 log.record_count(), log.devices.size(),
                                 log.devices.size() == 1 ? "" : "s",
                                 is_ours ? kTractusLog : kHidRecorder));
}

} // namespace

void add_convert_verb(CLI::App& root, Action& action)
{
    auto arguments = std::make_shared<ConvertArguments>();
    auto* const verb
        = root.add_subcommand("convert", "Turn a recording into another program's format");
    verb->add_option("IN", arguments->input,
                     "A .tractus-log or hid-recorder file, what usbhid-dump printed, or what "
                     "\"libinput record --with-hidraw\" wrote; which, its first lines tell")
        ->required();
    verb->add_option("-o,--output", arguments->output, "The file to write")
        ->type_name("FILE")
        ->required();
    verb->add_option("--to", arguments->format,
                     "tractus-log or hid-recorder; without it, a FILE that ends in .tractus-log "
                     "is one, and any other is hid-recorder's")
        ->type_name("FORMAT")
        ->check(one_of({ kTractusLog, kHidRecorder }));
    verb->add_option("--ids", arguments->ids,
                     "The devices' ids, for recordings that do not name them, as usbhid-dump's: "
                     "they choose the decoder")
        ->type_name("VENDOR:PRODUCT")
        ->check(device_ids());
    verb->footer(
        "hid-recorder's format, which hid-replay plays, has no place for the rig, changes of\n"
        "tool, unplugging, USB strings and what is no HID device: they stay behind.");
    verb->callback([arguments, &action] { action = [arguments] { return convert(*arguments); }; });
}

} // namespace tractus
