#include "drivers/log.h"

#include "drivers/file.h"
#include "drivers/report_source.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/core.h>
#include <limits>
#include <optional>

namespace tractus {

namespace {

constexpr std::size_t kMaxReportBytes = sizeof(RawReport::storage);
constexpr std::size_t kMaxLineBytes = std::size_t { 1 } << 20;
constexpr std::size_t kMaxLogBytes = std::size_t { 1 } << 30;
constexpr std::size_t kMaxDevices = 1024;
constexpr std::size_t kNanosecondDigits = 9;

constexpr std::array<std::int8_t, 256> make_hex_table()
{
    std::array<std::int8_t, 256> table {};
    table.fill(-1);
    for (int i = 0; i < 10; ++i)
        table[static_cast<std::size_t>('0' + i)] = static_cast<std::int8_t>(i);
    for (int i = 0; i < 6; ++i) {
        table[static_cast<std::size_t>('a' + i)] = static_cast<std::int8_t>(10 + i);
        table[static_cast<std::size_t>('A' + i)] = static_cast<std::int8_t>(10 + i);
    }
    return table;
}
constexpr auto kHex = make_hex_table();

int hex_digit(char c)
{
    return kHex[static_cast<unsigned char>(c)];
}

bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

// What LogWriter wrote with "\xHH" in it. A backslash that begins none stays.
std::string unescaped(std::string_view line)
{
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        bool const may_be_escape = line[i] == '\\' && i + 3 < line.size() && line[i + 1] == 'x';
        int const high = may_be_escape ? hex_digit(line[i + 2]) : -1;
        int const low = may_be_escape ? hex_digit(line[i + 3]) : -1;
        if ((high | low) < 0) {
            text += line[i];
            continue;
        }
        text += static_cast<char>(high << 4 | low);
        i += 3;
    }
    return text;
}

// The USB interface's number, from the kernel's path: "usb-0000:00:14.0-2/input1"; -1 if it names
// none.
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

// Reads one line from left to right. Each reader skips blanks first and says whether it found
// what it was asked for.
class LineCursor {
public:
    explicit LineCursor(std::string_view line)
        : at_(line.data())
        , end_(line.data() + line.size())
    {
    }

    template<typename Integer> bool integer(Integer& value, int base)
    {
        skip_blanks();
        auto const [next, error] = std::from_chars(at_, end_, value, base);
        if (error != std::errc())
            return false;
        at_ = next;
        return true;
    }

    // Seconds with a fraction of any length; what is finer than a nanosecond is cut off.
    bool time(Timestamp& time)
    {
        constexpr std::int64_t kMaxSeconds = 9'000'000'000;
        std::int64_t seconds = 0;
        if (!integer(seconds, 10) || seconds < 0 || seconds > kMaxSeconds)
            return false;
        std::int64_t nanoseconds = 0;
        if (at_ != end_ && *at_ == '.') {
            ++at_;
            std::size_t digits = 0;
            for (; at_ != end_ && *at_ >= '0' && *at_ <= '9'; ++at_, ++digits)
                if (digits < kNanosecondDigits)
                    nanoseconds = nanoseconds * 10 + (*at_ - '0');
            for (; digits < kNanosecondDigits; ++digits)
                nanoseconds *= 10;
        }
        time = timestamp_ns(seconds * 1'000'000'000 + nanoseconds);
        return true;
    }

    // Appends the `size` bytes of a line written as LogWriter does: each a blank and two digits,
    // and nothing else. False, and nothing appended, if it is not.
    bool plain_bytes(std::size_t size, std::vector<std::byte>& bytes)
    {
        auto const left = static_cast<std::size_t>(end_ - at_);
        if (left % 3 != 0 || left / 3 != size) // A product could wrap around.
            return false;
        auto const old_size = bytes.size();
        bytes.resize(old_size + size);
        int wrong = 0;
        char const* at = at_;
        for (auto* byte = bytes.data() + old_size; at != end_; at += 3, ++byte) {
            int const value = hex_digit(at[1]) * 16 | hex_digit(at[2]);
            wrong |= value | (at[0] ^ ' ') << 8;
            *byte = static_cast<std::byte>(value);
        }
        if (wrong & ~0xff) {
            bytes.resize(old_size);
            return false;
        }
        at_ = end_;
        return true;
    }

    // Appends every byte up to the line's end. False if something else than bytes is there.
    bool hex_bytes(std::vector<std::byte>& bytes)
    {
        for (;;) {
            skip_blanks();
            if (at_ == end_)
                return true;
            if (end_ - at_ < 2)
                return false;
            int const high = hex_digit(at_[0]);
            int const low = hex_digit(at_[1]);
            if ((high | low) < 0)
                return false;
            bytes.push_back(static_cast<std::byte>(high << 4 | low));
            at_ += 2;
            if (at_ != end_ && !is_blank(*at_))
                return false;
        }
    }

    std::string_view word()
    {
        skip_blanks();
        auto const* const begin = at_;
        while (at_ != end_ && !is_blank(*at_))
            ++at_;
        return { begin, static_cast<std::size_t>(at_ - begin) };
    }

    std::string_view rest()
    {
        skip_blanks();
        return { at_, static_cast<std::size_t>(end_ - at_) };
    }

private:
    void skip_blanks()
    {
        while (at_ != end_ && is_blank(*at_))
            ++at_;
    }

    char const* at_;
    char const* end_;
};

class Reader {
public:
    explicit Reader(std::string_view name) { log_.name = name; }

    // So many bytes will come, or fewer.
    void expect(std::size_t bytes);

    // The next piece of the text, cut anywhere.
    Result<void> feed(std::string_view piece);

    // When all of it has come. Once.
    Result<Log> finish();

private:
    // What is known of one device number.
    struct Numbered {
        std::size_t number = 0;
        bool has_descriptor = false;
    };

    Result<void> take_line(std::string_view line);
    Result<void> read_line(std::string_view line);
    Result<void> read_report(std::string_view content);
    Result<void> read_departure(std::string_view content);
    Result<void> read_descriptor(std::string_view content);
    void read_device_number(std::string_view content);
    void read_ids(std::string_view content);
    void read_string(std::string_view content);
    void read_tool(std::string_view content);
    Result<void> check_described() const;
    DeviceInfo& device();
    void warn(std::string message);
    tl::unexpected<Error> broken(std::string const& what) const;

    Log log_;
    std::string begun_line_;            // What the last piece had of a line that it did not end.
    std::vector<Numbered> numbered_;    // Beside log_.devices.
    std::size_t number_ = 0;            // As the last D line says.
    std::optional<std::size_t> device_; // Index of number_; none until something is said of it.
    std::size_t line_ = 0;
    bool is_whole_ = true; // Does the line end with a line break?
};

tl::unexpected<Error> Reader::broken(std::string const& what) const
{
    return fail(Fault::User, fmt::format("{}:{}: {}", log_.name, line_, what));
}

void Reader::warn(std::string message)
{
    if (log_.warning_count++ < kMaxLogWarnings)
        log_.warnings.push_back({ line_, std::move(message) });
}

void Reader::expect(std::size_t bytes)
{
    // A report of ten bytes takes some fifty characters: one allocation for most logs.
    log_.records.reserve(bytes / 48);
    log_.bytes.reserve(bytes / 4);
}

Result<void> Reader::feed(std::string_view piece)
{
    if (line_ == 0 && begun_line_.empty())
        TRY(refuse_wide_text(piece, log_.name));
    for (;;) {
        auto const end = piece.find('\n');
        if (begun_line_.size() + std::min(end, piece.size()) > kMaxLineBytes)
            return fail(Fault::User,
                        fmt::format("{}:{}: a line of more than {} bytes: this is no log",
                                    log_.name, line_ + 1, kMaxLineBytes));
        if (end == std::string_view::npos)
            break;
        if (begun_line_.empty()) {
            TRY(take_line(piece.substr(0, end)));
        } else {
            begun_line_.append(piece.substr(0, end));
            TRY(take_line(begun_line_));
            begun_line_.clear();
        }
        piece.remove_prefix(end + 1);
    }
    begun_line_.append(piece);
    return {};
}

Result<void> Reader::take_line(std::string_view line)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (++line_ == 1 && line.starts_with(kByteOrderMark))
        line.remove_prefix(kByteOrderMark.size());
    while (line.ends_with('\r'))
        line.remove_suffix(1);
    return read_line(line);
}

Result<Log> Reader::finish()
{
    is_whole_ = false;
    if (!begun_line_.empty())
        TRY(take_line(begun_line_));
    if (std::none_of(numbered_.begin(), numbered_.end(),
                     [](auto const& n) { return n.has_descriptor; }))
        return fail(Fault::User,
                    fmt::format("{} is not a log: none of its {} lines is a report descriptor "
                                "(\"R: <length> <bytes>\")",
                                log_.name, line_));
    for (std::size_t i = 0; i < log_.devices.size(); ++i)
        log_.devices[i].location = fmt::format("{}:device {}", log_.name, numbered_[i].number);
    return std::move(log_);
}

Result<void> Reader::read_line(std::string_view line)
{
    if (line.size() < 2 || line[1] != ':')
        return {};
    auto const content = line.substr(2);
    switch (line[0]) {
    case 'E':
        return read_report(content);
    case 'G':
        return read_departure(content);
    case 'R':
        return read_descriptor(content);
    case 'D':
        read_device_number(content);
        break;
    case 'N':
        device().name = LineCursor(content).rest();
        break;
    case 'P':
        device().physical_path = LineCursor(content).rest();
        device().interface_number = interface_in(device().physical_path);
        break;
    case 'M':
        device().manufacturer = unescaped(LineCursor(content).rest());
        break;
    case 'U':
        device().serial_number = unescaped(LineCursor(content).rest());
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
        if (!is_whole_) {
            warn("the last line is cut off: a line of the rig is dropped");
            break;
        }
        log_.rig_text += content.starts_with(' ') ? content.substr(1) : content;
        log_.rig_text += '\n';
        break;
    default:
        break;
    }
    return {};
}

Result<void> Reader::check_described() const
{
    if (device_ && numbered_[*device_].has_descriptor)
        return {};
    return broken(fmt::format(
        "a report of device {}, which has no report descriptor (R line) before it", number_));
}

Result<void> Reader::read_departure(std::string_view content)
{
    TRY(check_described());
    Timestamp time {};
    if (!is_whole_)
        warn("the last line is cut off: a departure is dropped");
    else if (LineCursor(content).time(time))
        log_.records.push_back({ .time = time,
                                 .offset = static_cast<std::uint32_t>(log_.bytes.size()),
                                 .device = static_cast<std::uint16_t>(*device_) });
    else
        warn("not a departure (\"G: <seconds>\"): skipped");
    return {};
}

Result<void> Reader::read_report(std::string_view content)
{
    TRY(check_described());
    LineCursor cursor(content);
    Timestamp time {};
    std::size_t size = 0;
    auto const offset = log_.bytes.size();
    bool const is_report = cursor.time(time) && cursor.integer(size, 10)
        && (cursor.plain_bytes(size, log_.bytes) || cursor.hex_bytes(log_.bytes));
    auto const found = log_.bytes.size() - offset;
    if (is_report && found == size && size > 0 && size <= kMaxReportBytes) {
        log_.records.push_back({ .time = time,
                                 .offset = static_cast<std::uint32_t>(offset),
                                 .size = static_cast<std::uint16_t>(size),
                                 .device = static_cast<std::uint16_t>(*device_) });
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

Result<void> Reader::read_descriptor(std::string_view content)
{
    LineCursor cursor(content);
    std::size_t size = 0;
    std::vector<std::byte> bytes;
    if (!cursor.integer(size, 10) || !cursor.hex_bytes(bytes))
        return broken("not a report descriptor (\"R: <length> <bytes>\")");
    if (bytes.size() != size)
        return broken(
            fmt::format("a report descriptor of {} bytes that announces {}", bytes.size(), size));
    auto& info = device();
    auto& has_descriptor = numbered_[*device_].has_descriptor;
    if (!has_descriptor)
        info.report_descriptor = std::move(bytes);
    else if (info.report_descriptor != bytes)
        warn(fmt::format("a second, different report descriptor of device {}: skipped", number_));
    has_descriptor = true;
    return {};
}

void Reader::read_device_number(std::string_view content)
{
    std::size_t number = 0;
    if (!LineCursor(content).integer(number, 10)) {
        warn("not a device number (\"D: <number>\"): skipped");
        return;
    }
    number_ = number;
    auto const found = std::find_if(numbered_.begin(), numbered_.end(),
                                    [&](auto const& n) { return n.number == number; });
    device_.reset();
    if (found != numbered_.end())
        device_ = static_cast<std::size_t>(found - numbered_.begin());
}

// The device that the lines are about. The last one takes what exceeds the number of devices that
// a sane file has.
DeviceInfo& Reader::device()
{
    if (!device_) {
        if (log_.devices.size() < kMaxDevices) {
            log_.devices.emplace_back();
            numbered_.push_back({ .number = number_ });
        } else {
            warn(fmt::format("more than {} devices", kMaxDevices));
        }
        device_ = log_.devices.size() - 1;
    }
    return log_.devices[*device_];
}

void Reader::read_ids(std::string_view content)
{
    LineCursor cursor(content);
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

void Reader::read_string(std::string_view content)
{
    constexpr int kMaxIndex = 255; // USB 2.0 table 9-8: a byte.
    LineCursor cursor(content);
    int index = 0;
    if (!is_whole_)
        warn("the last line is cut off: a string of the device is dropped");
    else if (!cursor.integer(index, 10) || index < 0 || index > kMaxIndex)
        warn("not a device's string (\"S: <index> <text>\"): skipped");
    else
        device().strings[index] = unescaped(cursor.rest());
}

void Reader::read_tool(std::string_view content)
{
    LineCursor cursor(content);
    LogTool tool { .position = log_.records.size() };
    bool const has_time = cursor.time(tool.time);
    tool.tool = cursor.word();
    tool.arguments = cursor.rest();
    if (!is_whole_)
        warn("the last line is cut off: a change of tool is dropped");
    else if (!has_time || tool.tool.empty())
        warn("not a change of tool (\"T: <seconds> <tool>\"): skipped");
    else
        log_.tools.push_back(std::move(tool));
}

} // namespace

Result<Log> parse_log(std::string_view text, std::string_view name)
{
    if (text.size() > std::numeric_limits<std::uint32_t>::max())
        return fail(Fault::User, fmt::format("{} is larger than 4 GiB", name));
    Reader reader(name);
    reader.expect(text.size());
    TRY(reader.feed(text));
    return reader.finish();
}

Result<Log> read_log(std::filesystem::path const& path)
{
    Reader reader(path.string());
    std::error_code no_size; // A pipe has none.
    auto const size = std::filesystem::file_size(path, no_size);
    if (!no_size)
        reader.expect(std::min<std::size_t>(size, kMaxLogBytes));
    TRY(read_file_in_pieces(path, kMaxLogBytes,
                            [&](std::string_view piece) { return reader.feed(piece); }));
    return reader.finish();
}

std::string summarize_warnings(Log const& log)
{
    if (log.warnings.empty())
        return {};
    auto const& first = log.warnings.front();
    if (log.warning_count == 1)
        return fmt::format("{}:{}: {}", log.name, first.line, first.message);
    return fmt::format("{}: {} odd lines, the first is line {}: {}", log.name, log.warning_count,
                       first.line, first.message);
}

} // namespace tractus
