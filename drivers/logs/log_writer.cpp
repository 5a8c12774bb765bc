#include "drivers/logs/log_writer.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <iterator>

namespace tractus::drivers {

// Replaces line breaks, since a line break inside a name would begin another line of the log.
static std::string one_line(std::string_view text)
{
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
}

// Escapes any text to a single line. read_log() decodes it.
static std::string escaped(std::string_view text)
{
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        auto const code = static_cast<unsigned char>(text[i]);
        bool const is_edge_blank = text[i] == ' ' && (i == 0 || i + 1 == text.size());
        if (code < ' ' || code == 0x7f || text[i] == '\\' || is_edge_blank)
            fmt::format_to(std::back_inserter(line), "\\x{:02x}", code);
        else
            line += text[i];
    }
    return line;
}

LogWriter::LogWriter(std::ostream& out, LogHeader const& header)
    : out_(out)
    , start_(header.start)
    , device_count_(header.devices.size())
{
    for (std::size_t i = 0; i < device_count_; ++i)
        append_device(i, header.devices[i]);
    for (std::string_view left = header.rig_text; !left.empty();) {
        auto const end = left.find('\n');
        fmt::format_to(std::back_inserter(line_), "C: {}\n", left.substr(0, end));
        left.remove_prefix(end == std::string_view::npos ? left.size() : end + 1);
    }
    write_line();
}

void LogWriter::append_device(std::size_t index, DeviceInfo const& info)
{
    auto const out = std::back_inserter(line_);
    if (device_count_ > 1)
        fmt::format_to(out, "D: {}\n", index);
    current_device_ = index;
    fmt::format_to(out, "R: {}", info.report_descriptor.size());
    append_bytes(info.report_descriptor);
    fmt::format_to(out, "\nN: {}\nP: {}\nI: {:x} {:04x} {:04x}\n", one_line(info.name),
                   one_line(info.physical_path), info.bus, info.vendor_id, info.product_id);
    if (!info.manufacturer.empty())
        fmt::format_to(out, "M: {}\n", escaped(info.manufacturer));
    if (!info.serial_number.empty())
        fmt::format_to(out, "U: {}\n", escaped(info.serial_number));
    if (info.size_mm)
        fmt::format_to(out, "A: {} {}\n", info.size_mm->x(), info.size_mm->y());
    for (auto const& [number, text] : info.strings)
        fmt::format_to(out, "S: {} {}\n", number, escaped(text));
}

void LogWriter::append_bytes(std::span<std::byte const> bytes)
{
    constexpr char kDigits[] = "0123456789abcdef";
    for (auto const byte : bytes) {
        auto const value = std::to_integer<unsigned>(byte);
        line_ += { ' ', kDigits[value >> 4], kDigits[value & 15] };
    }
}

void LogWriter::append_time(char letter, Timestamp time)
{
    auto const microseconds = std::max<std::int64_t>((time - start_).count() / 1000, 0);
    fmt::format_to(std::back_inserter(line_), "{}: {:06}.{:06}", letter, microseconds / 1'000'000,
                   microseconds % 1'000'000);
}

void LogWriter::write_report(std::size_t device, Timestamp time, std::span<std::byte const> bytes)
{
    CHECK(device < device_count_);
    if (device != current_device_)
        fmt::format_to(std::back_inserter(line_), "D: {}\n", device);
    current_device_ = device;
    append_time(bytes.empty() ? 'G' : 'E', time);
    if (!bytes.empty())
        fmt::format_to(std::back_inserter(line_), " {}", bytes.size());
    append_bytes(bytes);
    line_ += '\n';
    write_line();
}

void LogWriter::write_tool(Timestamp time, std::string_view tool, std::string_view arguments)
{
    append_time('T', time);
    fmt::format_to(std::back_inserter(line_), " {}{}{}\n", one_line(tool),
                   arguments.empty() ? "" : " ", one_line(arguments));
    write_line();
}

void LogWriter::write_line()
{
    out_.write(line_.data(), static_cast<std::streamsize>(line_.size()));
    line_.clear();
}

Result<void> LogWriter::flush()
{
    errno = 0;
    out_.flush();
    if (out_)
        return {};
    return fail(Fault::User,
                fmt::format("cannot write the log: {}",
                            errno ? std::strerror(errno) : "the stream takes no more"));
}

} // namespace tractus::drivers
