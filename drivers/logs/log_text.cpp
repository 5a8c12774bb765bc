#include "drivers/logs/log_text.h"

#include "drivers/logs/log_line.h"
#include "drivers/reports/report_source.h"
#include "engine/base/file.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

namespace {

constexpr std::size_t kMaxReportBytes = sizeof(RawReport::storage);
constexpr std::size_t kMaxDescribedBytes = std::size_t { 16 } << 20;
constexpr std::size_t kMaxDevices = 1024;

// Reports of different devices may be out of order in a log by less than this.
constexpr Duration kMaxDisorder = std::chrono::milliseconds(100);
// Pause inserted between two recordings in one file: long enough to end a stroke, and too short for
// a sensor to count as silent.
constexpr Duration kBetweenParts = std::chrono::milliseconds(200);

// Returns the USB interface number in the kernel's path, such as 1 in "usb-0000:00:14.0-2/input1";
// -1 if there is none.
int interface_in(std::string_view physical_path)
{
    constexpr std::string_view kInput = "/input";
    auto const at = physical_path.rfind(kInput);
    int number = -1;
    if (at != std::string_view::npos && physical_path.starts_with("usb-"))
        std::from_chars(physical_path.data() + at + kInput.size(),
                        physical_path.data() + physical_path.size(), number);
    return number;
}

} // namespace

LogText::LogText(std::string_view name, std::size_t most_bytes)
    : most_bytes_(most_bytes)
    , lines_(std::string(name), [this](std::string_view line) { return take_line(line); })
{
    log_.name = name;
}

LogText::LogText(std::string_view name, LogPlace place)
    : LogText(name)
{
    place_ = std::move(place);
    is_begin_ = false;
    log_.devices.resize(place_.numbered.size());
}

void LogText::forget_records()
{
    log_.records.clear();
    log_.bytes.clear();
    log_.tools.clear();
    log_.rig_text.clear();
    described_bytes_ = 0;
}

tl::unexpected<Error> LogText::broken(std::string const& what) const
{
    return fail(Fault::User, fmt::format("{}:{}: {}", log_.name, place_.line, what));
}

void LogText::warn(std::string message)
{
    if (log_.warning_count++ < kMaxLogWarnings)
        log_.warnings.push_back({ place_.line, std::move(message) });
}

void LogText::expect(std::size_t bytes)
{
    // A report of ten bytes takes about 48 characters, so most logs need one allocation.
    log_.records.reserve(bytes / 48);
    log_.bytes.reserve(bytes / 4);
}

Result<void> LogText::feed(std::string_view piece)
{
    if (is_begin_) {
        TRY(refuse_wide_text(piece, log_.name));
        is_begin_ = false;
    }
    return lines_.feed(piece);
}

Result<void> LogText::take_line(std::string_view line)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    place_.offset += line.size() + 1;
    if (++place_.line == 1 && line.starts_with(kByteOrderMark))
        line.remove_prefix(kByteOrderMark.size());
    while (line.ends_with('\r'))
        line.remove_suffix(1);
    TRY(read_line(line));
    auto const kept = log_.records.size() * sizeof(LogRecord) + log_.bytes.size();
    if (!rest_ && kept >= most_bytes_)
        rest_ = place_;
    return {};
}

Result<void> LogText::end()
{
    is_whole_ = false;
    return lines_.end();
}

Result<Log> LogText::take_log()
{
    auto const& numbered = place_.numbered;
    if (std::none_of(numbered.begin(), numbered.end(),
                     [](auto const& n) { return n.has_descriptor; }))
        return fail(Fault::User,
                    fmt::format("{} is not a log: none of its {} lines is a report descriptor "
                                "(\"R: <length> <bytes>\")",
                                log_.name, place_.line));
    for (std::size_t i = 0; i < log_.devices.size(); ++i)
        log_.devices[i].location = fmt::format("{}:device {}", log_.name, numbered[i].number);
    return std::move(log_);
}

Result<void> LogText::read_line(std::string_view line)
{
    if (line.size() < 2 || line[1] != ':')
        return {};
    auto const content = line.substr(2);
    if (line[0] == 'E')
        return read_report(content);
    if (line[0] == 'G')
        return read_departure(content);
    return read_described_line(line[0], content);
}

// Reads a line that describes a device, the rig or a change of tool. What it describes stays in
// memory, however long the log is.
Result<void> LogText::read_described_line(char kind, std::string_view content)
{
    if (std::string_view("RDNPMUASITC").find(kind) == std::string_view::npos)
        return {};
    if (kind != 'D' && kind != 'I') // D and I lines take no memory that grows with their number.
        described_bytes_ += content.size() + sizeof(LogTool);
    if (described_bytes_ > kMaxDescribedBytes)
        return broken(fmt::format("more than {} bytes that describe devices, the rig and tools: "
                                  "this is no log",
                                  kMaxDescribedBytes));
    switch (kind) {
    case 'R':
        return read_descriptor(content);
    case 'D':
        read_device_number(content);
        break;
    case 'N':
        device().name = LogLine(content).rest();
        break;
    case 'P':
        device().physical_path = LogLine(content).rest();
        device().interface_number = interface_in(device().physical_path);
        break;
    case 'M':
        device().manufacturer = LogLine(content).unescaped_rest();
        break;
    case 'U':
        device().serial_number = LogLine(content).unescaped_rest();
        break;
    case 'A':
        read_size(content);
        break;
    case 'S':
        read_string(content);
        break;
    case 'I':
        read_ids(content);
        break;
    case 'T':
        read_tool(content);
        break;
    case 'C':
        read_rig_line(content);
        break;
    default:
        break;
    }
    return {};
}

void LogText::read_rig_line(std::string_view content)
{
    if (!is_whole_)
        return warn("the last line is cut off: a line of the rig is dropped");
    if (totals_.count > 0) {
        if (!std::exchange(place_.has_second_rig, true))
            warn("another calibration after the first report: skipped, the first one counts");
        return;
    }
    log_.rig_text += content.starts_with(' ') ? content.substr(1) : content;
    log_.rig_text += '\n';
}

Result<void> LogText::check_described() const
{
    if (place_.device && place_.numbered[*place_.device].has_descriptor)
        return {};
    return broken(fmt::format(
        "a report of device {}, which has no report descriptor (R line) before it", place_.number));
}

Result<void> LogText::read_departure(std::string_view content)
{
    TRY(check_described());
    Timestamp time {};
    if (!is_whole_)
        warn("the last line is cut off: a departure is dropped");
    else if (LogLine(content).time(time))
        take_record(time, log_.bytes.size());
    else
        warn("not a departure (\"G: <seconds>\"): skipped");
    return {};
}

// Adds a record. Its bytes are those in log_.bytes from `offset` to the end.
void LogText::take_record(Timestamp time, std::size_t offset)
{
    if (place_.latest && *place_.latest - time > kMaxDisorder)
        begin_part(time);
    place_.latest = std::max(time, place_.latest.value_or(time));
    place_.numbered[*place_.device].is_there = log_.bytes.size() > offset;
    add_record(time + place_.shift, *place_.device, offset);
}

void LogText::add_record(Timestamp time, std::size_t device, std::size_t offset)
{
    if (totals_.count++ == 0)
        totals_.begin = time;
    totals_.end = time;
    if (rest_)
        log_.bytes.resize(offset);
    else
        log_.records.push_back({ .time = time,
                                 .offset = static_cast<std::uint32_t>(offset),
                                 .size = static_cast<std::uint16_t>(log_.bytes.size() - offset),
                                 .device = static_cast<std::uint16_t>(device) });
}

// Begins the next of several recordings in one file: disconnects all devices, and lets the times
// continue after a pause, so that no stroke or gesture spans two recordings.
void LogText::begin_part(Timestamp time)
{
    auto const back = *place_.latest - time;
    warn(fmt::format("the times go back by {:.3f} s: another recording begins here, whose times "
                     "count on from the one before",
                     to_seconds(back)));
    auto const end = *place_.latest + place_.shift;
    auto const count_before = totals_.count;
    // The new record's bytes have been appended already. They are set aside, because a
    // disconnection has no bytes.
    std::vector<std::byte> bytes;
    bytes.swap(log_.bytes);
    for (std::size_t i = 0; i < place_.numbered.size(); ++i)
        if (std::exchange(place_.numbered[i].is_there, false))
            add_record(end, i, log_.bytes.size());
    bytes.swap(log_.bytes);
    auto const shift = end + kBetweenParts - time;
    move_last_tools(time, shift, count_before);
    place_.shift = shift;
    place_.latest.reset();
}

// Shifts changes of tool that are written between two recordings. Only those whose times show that
// they belong to the second recording are shifted.
void LogText::move_last_tools(Timestamp time, Duration shift, std::size_t count_before)
{
    for (auto tool = log_.tools.rbegin();
         tool != log_.tools.rend() && tool->position == count_before; ++tool) {
        auto const said = tool->time - place_.shift;
        if (std::chrono::abs(said - time) >= std::chrono::abs(said - *place_.latest))
            continue;
        tool->time = said + shift;
        tool->position = totals_.count;
    }
}

Result<void> LogText::read_report(std::string_view content)
{
    TRY(check_described());
    LogLine cursor(content);
    Timestamp time {};
    std::size_t size = 0;
    auto const offset = log_.bytes.size();
    bool const is_report = cursor.time(time) && cursor.integer(size, 10)
        && (cursor.plain_bytes(size, log_.bytes) || cursor.hex_bytes(log_.bytes));
    auto const found = log_.bytes.size() - offset;
    if (is_report && found == size && size > 0 && size <= kMaxReportBytes) {
        take_record(time, offset);
        return {};
    }
    log_.bytes.resize(offset);
    if (!is_whole_)
        warn("the last line is cut off: a report is dropped");
    else if (!is_report)
        warn("not a report (\"E: <seconds> <length> <bytes>\"): skipped");
    else if (found != size)
        warn(fmt::format("a report of {} bytes that announces {}: skipped", found, size));
    else
        warn(fmt::format("a report of {} bytes, which is not in 1 to {}: skipped", size,
                         kMaxReportBytes));
    return {};
}

Result<void> LogText::read_descriptor(std::string_view content)
{
    LogLine cursor(content);
    std::size_t size = 0;
    std::vector<std::byte> bytes;
    if (!cursor.integer(size, 10) || !cursor.hex_bytes(bytes))
        return broken("not a report descriptor (\"R: <length> <bytes>\")");
    if (bytes.size() != size)
        return broken(
            fmt::format("a report descriptor of {} bytes that announces {}", bytes.size(), size));
    auto& info = device();
    auto& has_descriptor = place_.numbered[*place_.device].has_descriptor;
    if (!has_descriptor)
        info.report_descriptor = std::move(bytes);
    else if (info.report_descriptor != bytes)
        warn(fmt::format("a second, different report descriptor of device {}: skipped",
                         place_.number));
    has_descriptor = true;
    return {};
}

void LogText::read_device_number(std::string_view content)
{
    std::size_t number = 0;
    if (!LogLine(content).integer(number, 10)) {
        warn("not a device number (\"D: <number>\"): skipped");
        return;
    }
    place_.number = number;
    auto const found = std::find_if(place_.numbered.begin(), place_.numbered.end(),
                                    [&](auto const& n) { return n.number == number; });
    place_.device.reset();
    if (found != place_.numbered.end())
        place_.device = static_cast<std::size_t>(found - place_.numbered.begin());
}

// Returns the device that the current lines describe. All devices beyond kMaxDevices share the last
// one.
DeviceInfo& LogText::device()
{
    if (!place_.device) {
        if (log_.devices.size() < kMaxDevices) {
            log_.devices.emplace_back();
            place_.numbered.push_back({ .number = place_.number });
        } else {
            warn(fmt::format("more than {} devices", kMaxDevices));
        }
        place_.device = log_.devices.size() - 1;
    }
    return log_.devices[*place_.device];
}

void LogText::read_ids(std::string_view content)
{
    LogLine cursor(content);
    std::uint16_t bus = 0;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    if (!cursor.integer(bus, 16) || !cursor.integer(vendor, 16) || !cursor.integer(product, 16)) {
        warn("not a device's ids (\"I: <bus> <vendor> <product>\"): skipped");
        return;
    }
    auto& info = device();
    info.bus = bus;
    info.vendor_id = vendor;
    info.product_id = product;
}

void LogText::read_size(std::string_view content)
{
    constexpr int kMinMm = 20;
    constexpr int kMaxMm = 2000;
    LogLine cursor(content);
    int width_mm = 0;
    int height_mm = 0;
    bool const has_both = cursor.integer(width_mm, 10) && cursor.integer(height_mm, 10);
    if (!is_whole_)
        warn("the last line is cut off: a tablet's size is dropped");
    else if (!has_both || std::min(width_mm, height_mm) < kMinMm
             || std::max(width_mm, height_mm) > kMaxMm)
        warn("not a tablet's size (\"A: <width> <height>\", 20 to 2000 mm): skipped");
    else
        device().size_mm = Vec2(width_mm, height_mm);
}

void LogText::read_string(std::string_view content)
{
    constexpr int kMaxIndex = 255; // An index is one byte (USB 2.0, table 9-8).
    LogLine cursor(content);
    int index = 0;
    if (!is_whole_)
        warn("the last line is cut off: a string of the device is dropped");
    else if (!cursor.integer(index, 10) || index < 0 || index > kMaxIndex)
        warn("not a device's string (\"S: <index> <text>\"): skipped");
    else
        device().strings[index] = cursor.unescaped_rest();
}

void LogText::read_tool(std::string_view content)
{
    LogLine cursor(content);
    LogTool tool { .position = totals_.count };
    bool const has_time = cursor.time(tool.time);
    tool.time += place_.shift;
    tool.tool = cursor.word();
    tool.arguments = cursor.rest();
    if (!is_whole_)
        warn("the last line is cut off: a change of tool is dropped");
    else if (!has_time || tool.tool.empty())
        warn("not a change of tool (\"T: <seconds> <tool>\"): skipped");
    else
        log_.tools.push_back(std::move(tool));
}

} // namespace tractus::drivers
