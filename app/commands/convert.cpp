#include "app/commands/convert.h"

#include "app/io/stroke_file.h"
#include "app/options/checks.h"
#include "app/options/recordings_help.h"
#include "app/options/shared_options.h"
#include "app/station/log_replay.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "engine/base/file.h"

#include <charconv>
#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::commands {

namespace {

namespace fs = std::filesystem;

constexpr char const* kHidRecorder = "hid-recorder";
constexpr char const* kTractusLog = "tractus-log";
constexpr char const* kFrontView = "front";
constexpr char const* kSideView = "side";
constexpr char const* kTopView = "top";

struct ConvertArguments {
    fs::path input;
    fs::path output;
    std::string format; // Output format; empty: determined by the extension of the output's name.
    std::string ids;
    std::string rig;
    std::string height;
    std::string view = kFrontView;
    tools::Methods methods;
};

// Parses USB ids such as "256c:006e" as vendor and product numbers.
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

// Removes the devices that hid-recorder's format cannot describe (it describes HID devices only, by
// name, path and ids). Returns for each device of the log its new index, or no value if it was
// removed.
std::vector<std::optional<std::size_t>> keep_what_hid_recorder_knows(drivers::LogHeader& header)
{
    std::vector<std::optional<std::size_t>> places;
    std::vector<drivers::DeviceInfo> kept;
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

Result<void> write_hid_recorder(std::ostream& out, drivers::Log const& log)
{
    drivers::LogHeader header { .devices = log.devices };
    auto const places = keep_what_hid_recorder_knows(header);
    if (header.devices.empty())
        return fail(Fault::User,
                    fmt::format("{} has no device with a report descriptor, which hid-recorder's "
                                "format needs: convert it to a .tractus-log",
                                log.name));
    drivers::LogWriter writer(out, header);
    drivers::LogCursor cursor(log);
    while (auto const* const report = TRY(cursor.next()))
        if (auto const place = places[report->device]; place && !report->bytes.empty())
            writer.write_report(*place, report->time, report->bytes);
    return writer.flush();
}

Result<void> write_tractus_log(std::ostream& out, drivers::Log const& log)
{
    drivers::LogWriter writer(out, { .devices = log.devices, .rig_text = log.rig_text });
    std::size_t tool = 0;
    auto const write_tools_until = [&](std::size_t position) {
        for (; tool < log.tools.size() && log.tools[tool].position <= position; ++tool)
            writer.write_tool(log.tools[tool].time, log.tools[tool].tool,
                              log.tools[tool].arguments);
    };
    drivers::LogCursor cursor(log);
    write_tools_until(0);
    while (auto const* const report = TRY(cursor.next())) {
        writer.write_report(report->device, report->time, report->bytes);
        write_tools_until(cursor.position());
    }
    return writer.flush();
}

bool wants_strokes(ConvertArguments const& arguments)
{
    return arguments.format.empty() && io::can_write_strokes_to(arguments.output);
}

// True for tools that draw a line; false for tools that select, point or erase.
bool is_drawing(tools::ToolKind const& tool)
{
    return tool.previewer && tool.ink.look == tools::InkStyle::Look::Line;
}

Result<std::vector<Stroke>> drawn_strokes(ConvertArguments const& arguments,
                                          drivers::Log const& log)
{
    station::ReplayOptions options { .methods = arguments.methods };
    if (!arguments.rig.empty())
        options.rig = TRY(calib::load_rig(arguments.rig));
    if (!arguments.height.empty())
        options.height = TRY(calib::parse_height_scenario(arguments.height));
    auto replay = TRY(station::LogReplay::create(log, options));
    for (auto const& sentence : replay.left_out())
        terminal::print_warning(sentence);
    replay.advance_to(Timestamp::max());
    if (auto const& outcome = replay.outcome(); !outcome)
        return tl::unexpected(outcome.error());
    std::vector<Stroke> strokes;
    for (auto& [stroke, tool] : replay.station().take_strokes()) {
        bool const is_ink = !stroke.tips.empty() && !stroke.tips.front().eraser;
        if (is_ink && is_drawing(tool.kind()))
            strokes.push_back(std::move(stroke));
    }
    return strokes;
}

exports::StrokeView parse_view(std::string const& word)
{
    return word == kSideView ? exports::StrokeView::Side
        : word == kTopView   ? exports::StrokeView::Top
                             : exports::StrokeView::Front;
}

Result<void> convert_to_strokes(ConvertArguments const& arguments,
                                std::vector<Stroke> const& strokes)
{
    if (strokes.empty())
        return fail(Fault::User,
                    fmt::format("{}: nothing was drawn in it: there is no stroke to write",
                                arguments.input.string()));
    TRY(io::write_strokes(arguments.output, strokes, parse_view(arguments.view)));
    std::size_t tips = 0;
    for (auto const& stroke : strokes)
        tips += stroke.tips.size();
    return terminal::print_out(fmt::format("{}: {} stroke{} of {} points\n",
                                           arguments.output.string(), strokes.size(),
                                           strokes.size() == 1 ? "" : "s", tips));
}

Result<void> convert(ConvertArguments const& arguments)
{
    std::error_code ignored;
    if (fs::equivalent(arguments.input, arguments.output, ignored))
        return fail(Fault::User,
                    fmt::format("{} is the recording itself: choose another name for the output",
                                arguments.output.string()));
    TRY(check_writable(arguments.output));
    if (io::is_stroke_file(arguments.input) && wants_strokes(arguments))
        return convert_to_strokes(arguments, TRY(io::load_strokes(arguments.input)));
    auto log = TRY(drivers::read_log(arguments.input));
    if (auto const ids = parse_ids(arguments.ids))
        for (auto& info : log.devices) {
            info.vendor_id = ids->first;
            info.product_id = ids->second;
        }
    if (auto const warnings = drivers::summarize_warnings(log); !warnings.empty())
        terminal::print_warning(warnings);
    if (wants_strokes(arguments))
        return convert_to_strokes(arguments, TRY(drawn_strokes(arguments, log)));
    bool const is_ours = arguments.format.empty() ? arguments.output.extension() == ".tractus-log"
                                                  : arguments.format == kTractusLog;
    TRY(write_file(arguments.output, [&](std::ostream& out) {
        return is_ours ? write_tractus_log(out, log) : write_hid_recorder(out, log);
    }));
    return terminal::print_out(fmt::format("{}: {} reports of {} device{} as {}\n",
                                           arguments.output.string(), log.record_count(),
                                           log.devices.size(), log.devices.size() == 1 ? "" : "s",
                                           is_ours ? kTractusLog : kHidRecorder));
}

} // namespace

void add_convert_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<ConvertArguments>();
    arguments->methods = methods;
    auto* const command = root.add_subcommand(
        "convert", "Turn a recording into another program's format, or into curves");
    command
        ->add_option("IN", arguments->input,
                     fmt::format("A recording: {}; which, its first lines tell. For curves strokes "
                                 "in space, too: .tilt, .strokes or .txt",
                                 options::kRecordings))
        ->required();
    command->add_option("-o,--output", arguments->output, "The file to write")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--to", arguments->format,
                     "tractus-log or hid-recorder; without it, a FILE that ends in .tractus-log "
                     "is one, .glb, .svg, .strokes and .txt hold what was drawn as curves in "
                     "space, and any other is hid-recorder's")
        ->type_name("FORMAT")
        ->check(options::one_of({ kTractusLog, kHidRecorder }));
    command
        ->add_option("--ids", arguments->ids,
                     "The devices' ids, for recordings that do not name them, as usbhid-dump's: "
                     "they choose the decoder")
        ->type_name("VENDOR:PRODUCT")
        ->check(device_ids());
    options::add_rig_option(*command, arguments->rig);
    options::add_height_option(*command, arguments->height);
    command->add_option("--view", arguments->view, "From where an .svg sees the curves")
        ->type_name("front|side|top")
        ->check(options::one_of({ kFrontView, kSideView, kTopView }))
        ->capture_default_str();
    command->footer(
        "Curves are the strokes that draw, in millimetres: .glb has lines in metres, +y up,\n"
        ".svg a view at true scale, and .txt a point a line, which \"tractus replay\" reads.\n"
        "hid-recorder's format, which hid-replay plays, has no place for the rig, changes of\n"
        "tool, unplugging, USB strings and what is no HID device: they stay behind.");
    command->callback(
        [arguments, &action] { action = [arguments] { return convert(*arguments); }; });
}

} // namespace tractus::commands
