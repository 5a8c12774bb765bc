#include "drivers/logs/foreign_log.h"
#include "drivers/logs/foreign_log_builder.h"
#include "drivers/logs/line_splitter.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::drivers {

namespace {

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

// Parses "SECONDS.MICROSECONDS".
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

// The head of a block written by usbhid-dump.
struct DumpHead {
    std::string interface_name {}; // Name such as "003:005:001": bus, device, interface.
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

// Returns a line without trailing blanks and CR.
std::string_view without_end(std::string_view line)
{
    while (line.ends_with('\r') || line.ends_with(' '))
        line.remove_suffix(1);
    return line;
}

class DumpReader {
public:
    explicit DumpReader(std::string_view name)
        : builder_(name)
    {
    }

    Result<void> take_line(std::string_view line)
    {
        ++line_;
        line = without_end(line);
        if (!head_) {
            head_ = parse_dump_head(line);
            head_line_ = line_;
            return {};
        }
        if (line.empty())
            return end_block();
        for (unsigned value = 0; !line.empty() && take_number(line, value, 16) && value <= 0xff;)
            bytes_.push_back(static_cast<std::byte>(value));
        if (!line.empty() || bytes_.size() > kMaxBlockBytes) {
            builder_.warn(line_, "not the bytes of a block: skipped");
            forget_block();
        }
        return {};
    }

    Result<Log> take_log()
    {
        TRY(end_block());
        if (devices_.empty())
            return fail(Fault::User,
                        fmt::format("{} is not what usbhid-dump prints: no line is such as "
                                    "\"003:005:001:STREAM  1436110030.141241\"",
                                    builder_.log().name));
        return builder_.take();
    }

private:
    static constexpr std::size_t kMaxBlockBytes = std::size_t { 1 } << 16;

    void forget_block()
    {
        head_.reset();
        bytes_.clear();
    }

    Result<void> end_block()
    {
        if (!head_)
            return {};
        auto const device = TRY(device_of(*head_));
        if (head_->is_descriptor)
            builder_.log().devices[device].report_descriptor = bytes_;
        else
            TRY(builder_.append_report(head_line_, device, head_->time, bytes_));
        forget_block();
        return {};
    }

    Result<std::size_t> device_of(DumpHead const& head)
    {
        if (auto const known = devices_.find(head.interface_name); known != devices_.end())
            return known->second;
        auto const device = TRY(builder_.add_device(
            { .name = fmt::format("USB interface {}", head.interface_name),
              .location = fmt::format("{}:{}", builder_.log().name, head.interface_name),
              .physical_path = fmt::format("usb-{}/input{}", head.interface_name.substr(0, 7),
                                           head.interface_number),
              .interface_number = head.interface_number }));
        devices_[head.interface_name] = device;
        return device;
    }

    ForeignLogBuilder builder_;
    std::map<std::string, std::size_t> devices_; // Interface name → index in the log's devices.
    std::size_t line_ = 0;
    std::optional<DumpHead> head_; // Head of the block being read.
    std::size_t head_line_ = 0;
    std::vector<std::byte> bytes_;
};

} // namespace

bool begins_usbhid_dump_block(std::string_view line)
{
    return parse_dump_head(without_end(line)).has_value();
}

Result<Log> parse_usbhid_dump(std::istream& in, std::string_view name)
{
    DumpReader reader(name);
    TRY(feed_lines(in, name, [&](std::string_view line) { return reader.take_line(line); }));
    return reader.take_log();
}

} // namespace tractus::drivers
