#include "drivers/foreign_log.h"

#include "drivers/file.h"
#include "drivers/report_source.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/core.h>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <yaml-cpp/yaml.h>

namespace tractus {

namespace {

constexpr std::size_t kMaxForeignBytes = sizeof(RawReport::storage);

void warn(Log& log, std::size_t line, std::string message)
{
    if (log.warning_count++ < kMaxLogWarnings)
        log.warnings.push_back({ line, std::move(message) });
}

void append_report(Log& log, std::size_t line, std::size_t device, Timestamp time,
                   std::span<std::byte const> bytes)
{
    if (bytes.empty() || bytes.size() > kMaxForeignBytes)
        return warn(log, line,
                    fmt::format("a report of {} bytes, which is not in 1 to {}: skipped",
                                bytes.size(), kMaxForeignBytes));
    log.records.push_back({ .time = time,
                            .offset = static_cast<std::uint32_t>(log.bytes.size()),
                            .size = static_cast<std::uint16_t>(bytes.size()),
                            .device = static_cast<std::uint16_t>(device) });
    log.bytes.insert(log.bytes.end(), bytes.begin(), bytes.end());
}

// The first report is at 0.
void rebase(Log& log)
{
    if (log.records.empty())
        return;
    auto const earliest
        = std::min_element(log.records.begin(), log.records.end(),
                           [](auto const& a, auto const& b) { return a.time < b.time; })
              ->time;
    for (auto& record : log.records)
        record.time -= earliest.time_since_epoch();
}

std::string_view take_line(std::string_view& text)
{
    auto const end = text.find('\n');
    auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
        line.remove_suffix(1);
    return line;
}

template<typename Integer> bool take_number(std::string_view& text, Integer& value, int base = 10)
{
    while (text.starts_with(' '))
        text.remove_prefix(1);
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc())
        return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

// "SECONDS.MICROSECONDS"
std::optional<Timestamp> parse_time(std::string_view text)
{
    constexpr std::int64_t kMaxSeconds = 9'000'000'000;
    std::int64_t seconds = 0;
    std::int64_t microseconds = 0;
    if (!take_number(text, seconds) || seconds < 0 || seconds > kMaxSeconds
        || !text.starts_with('.'))
        return std::nullopt;
    text.remove_prefix(1);
    if (text.size() != 6 || !take_number(text, microseconds) || !text.empty())
        return std::nullopt;
    return timestamp_ns((seconds * 1'000'000 + microseconds) * 1000);
}

// The head of one of usbhid-dump's blocks.
struct DumpHead {
    std::string interface_name {}; // "003:005:001": bus, device, interface.
    int interface_number = 0;
    bool is_descriptor = false;
    Timestamp time {};
};

std::optional<DumpHead> parse_dump_head(std::string_view line)
{
    constexpr std::size_t kNameLength = 11;
    if (line.size() < kNameLength + 2 || line[3] != ':' || line[7] != ':'
        || line[kNameLength] != ':')
        return std::nullopt;
    DumpHead head { .interface_name = std::string(line.substr(0, kNameLength)) };
    auto number = line.substr(8, 3);
    line.remove_prefix(kNameLength + 1);
    auto const kind = line.substr(0, line.find(' '));
    line.remove_prefix(kind.size());
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    auto const time = parse_time(line);
    head.is_descriptor = kind == "DESCRIPTOR";
    if (!time || !take_number(number, head.interface_number)
        || (!head.is_descriptor && kind != "STREAM"))
        return std::nullopt;
    head.time = *time;
    return head;
}

class DumpReader {
public:
    DumpReader(std::string_view text, std::string_view name)
        : left_(text)
    {
        log_.name = name;
    }

    Result<Log> read()
    {
        while (!left_.empty()) {
            auto const line = take_line(left_);
            ++line_;
            if (auto const head = parse_dump_head(line))
                read_block(*head);
        }
        if (log_.devices.empty())
            return fail(Fault::User,
                        fmt::format("{} is not what usbhid-dump prints: no line is such as "
                                    "\"003:005:001:STREAM  1436110030.141241\"",
                                    log_.name));
        rebase(log_);
        return std::move(log_);
    }

private:
    void read_block(DumpHead const& head)
    {
        auto const first_line = line_;
        std::vector<std::byte> bytes;
        while (!left_.empty()) {
            auto line = take_line(left_);
            ++line_;
            if (line.empty())
                break;
            unsigned value = 0;
            while (!line.empty() && take_number(line, value, 16) && value <= 0xff)
                bytes.push_back(static_cast<std::byte>(value));
            if (!line.empty())
                return warn(log_, line_, "not the bytes of a block: skipped");
        }
        auto const device = device_of(head);
        if (head.is_descriptor)
            log_.devices[device].report_descriptor = std::move(bytes);
        else
            append_report(log_, first_line, device, head.time, bytes);
    }

    std::size_t device_of(DumpHead const& head)
    {
        auto const [found, is_new] = devices_.try_emplace(head.interface_name, devices_.size());
        if (is_new)
            log_.devices.push_back(
                { .name = fmt::format("USB interface {}", head.interface_name),
                  .location = fmt::format("{}:{}", log_.name, head.interface_name),
                  .interface_number = head.interface_number });
        return found->second;
    }

    std::string_view left_;
    Log log_;
    std::map<std::string, std::size_t> devices_; // Interface name → index in log_.devices.
    std::size_t line_ = 0;
};

std::vector<std::byte> bytes_of(YAML::Node const& list)
{
    std::vector<std::byte> bytes;
    for (auto const& value : list)
        bytes.push_back(static_cast<std::byte>(value.as<unsigned>()));
    return bytes;
}

DeviceInfo describe(YAML::Node const& device, std::string_view log_name)
{
    DeviceInfo info;
    if (auto const evdev = device["evdev"]) {
        info.name = evdev["name"].as<std::string>("");
        if (auto const id = evdev["id"]; id && id.size() >= 3) {
            info.bus = id[0].as<std::uint16_t>();
            info.vendor_id = id[1].as<std::uint16_t>();
            info.product_id = id[2].as<std::uint16_t>();
        }
    }
    info.location = fmt::format("{}:{}", log_name, device["node"].as<std::string>(""));
    if (auto const descriptor = device["hid"])
        info.report_descriptor = bytes_of(descriptor);
    return info;
}

// A hidraw node's reports stand among the events of one of the input devices it feeds.
void read_hid_events(Log& log, YAML::Node const& device)
{
    std::map<std::string, std::size_t> nodes; // hidraw node → index in log.devices.
    for (auto const& event : device["events"]) {
        auto const hid = event["hid"];
        if (!hid || !hid.IsMap())
            continue;
        auto const time = hid["time"];
        auto const when = timestamp_ns(
            (time[0].as<std::int64_t>() * 1'000'000 + time[1].as<std::int64_t>()) * 1000);
        auto const line = static_cast<std::size_t>(hid.Mark().line) + 1;
        for (auto const& entry : hid) {
            auto const key = entry.first.as<std::string>();
            if (!key.starts_with("hidraw"))
                continue;
            auto const [node, is_new] = nodes.try_emplace(key, log.devices.size());
            if (is_new)
                log.devices.push_back(describe(device, log.name));
            append_report(log, line, node->second, when, bytes_of(entry.second));
        }
    }
}

} // namespace

Result<Log> parse_usbhid_dump(std::string_view text, std::string_view name)
{
    return DumpReader(text, name).read();
}

Result<Log> parse_libinput_record(std::string_view text, std::string_view name)
{
    Log log;
    log.name = name;
    try {
        auto const root = YAML::Load(std::string(text));
        for (auto const& device : root["devices"])
            read_hid_events(log, device);
    } catch (YAML::Exception const& error) {
        return fail(Fault::User,
                    fmt::format("{}:{}: not a recording by libinput record: {}", name,
                                error.mark.line + 1, error.msg));
    }
    if (log.devices.empty())
        return fail(Fault::User,
                    fmt::format("{} has no raw reports: record it with \"libinput record "
                                "--with-hidraw\"",
                                name));
    rebase(log);
    return log;
}

LogFormat guess_log_format(std::string_view text)
{
    constexpr int kLines = 20;
    for (int i = 0; i < kLines && !text.empty(); ++i) {
        auto const line = take_line(text);
        if (parse_dump_head(line))
            return LogFormat::UsbhidDump;
        if (line.starts_with("ndevices:") || line.starts_with("libinput:"))
            return LogFormat::LibinputRecord;
    }
    return LogFormat::TractusLog;
}

Result<Log> read_any_log(std::filesystem::path const& path)
{
    auto const text = TRY(read_file(path));
    switch (guess_log_format(text)) {
    case LogFormat::UsbhidDump:
        return parse_usbhid_dump(text, path.string());
    case LogFormat::LibinputRecord:
        return parse_libinput_record(text, path.string());
    case LogFormat::TractusLog:
        break;
    }
    return parse_log(text, path.string());
}

} // namespace tractus
