#include "drivers/sensors/serial_line.h"

#include "drivers/links/sysfs.h"
#include "drivers/reports/clock.h"
#include "drivers/sensors/number_line.h"
#include "drivers/sensors/settings.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <string>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSerialKind = "serial";

struct BaudRate {
    int baud;
    speed_t speed;
};
constexpr std::array<BaudRate, 9> kBaudRates { {
    { 9600, B9600 },
    { 19200, B19200 },
    { 38400, B38400 },
    { 57600, B57600 },
    { 115200, B115200 },
    { 230400, B230400 },
    { 460800, B460800 },
    { 921600, B921600 },
    { 2000000, B2000000 },
} };

struct SerialSettings {
    speed_t speed = B115200;
    NumberFormat numbers {};
};

Result<SerialSettings> parse_serial_settings(std::string_view text)
{
    SerialSettings settings;
    for (auto const word : split_settings(text)) {
        if (auto const numbers = TRY(parse_greatest_number(word))) {
            settings.numbers = *numbers;
            continue;
        }
        auto const baud = number_between("", word, "");
        auto const rate = std::ranges::find(kBaudRates, baud.value_or(0), &BaudRate::baud);
        if (rate == kBaudRates.end())
            return fail(
                Fault::User,
                fmt::format("\"{}\" is no setting of a serial line: expected a usual baud "
                            "rate, such as 115200, or the greatest number, such as max=1023",
                            word));
        settings.speed = rate->speed;
    }
    return settings;
}

// Owner of an open file descriptor.
class SerialPort {
public:
    explicit SerialPort(int file)
        : file_(file)
    {
    }
    ~SerialPort()
    {
        if (file_ < 0)
            return;
        ::ioctl(file_, TIOCNXCL); // A pseudo-terminal would stay exclusive after it was closed.
        ::close(file_);
    }
    SerialPort(SerialPort&& other) noexcept
        : file_(std::exchange(other.file_, -1))
    {
    }
    SerialPort& operator=(SerialPort&&) = delete;

    int file() const { return file_; }

private:
    int file_;
};

tl::unexpected<Error> cannot_open_line(std::string const& node, int error)
{
    constexpr char const* kGroup
        = " (its group may: sudo adduser $USER dialout, then log in again)";
    constexpr char const* kBusy = " (another program has it: close the Arduino IDE's monitor)";
    return fail(Fault::User,
                fmt::format("cannot open {}: {}{}", node, std::strerror(error),
                            error == EACCES      ? kGroup
                                : error == EBUSY ? kBusy
                                                 : ""));
}

// Opens a serial port with eight bits, no parity, no flow control, and no processing of bytes.
Result<SerialPort> open_port(std::string const& node, speed_t speed)
{
    SerialPort port(::open(node.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (port.file() < 0)
        return cannot_open_line(node, errno);
    termios state {};
    if (::tcgetattr(port.file(), &state) != 0)
        return fail(Fault::User, fmt::format("{} is no serial line", node));
    ::cfmakeraw(&state);
    state.c_cflag |= CLOCAL | CREAD;
    state.c_cflag &= ~static_cast<tcflag_t>(HUPCL | CRTSCTS); // Many boards restart at a hang-up.
    ::cfsetspeed(&state, speed);
    if (::tcsetattr(port.file(), TCSANOW, &state) != 0 || ::ioctl(port.file(), TIOCEXCL) != 0)
        return cannot_open_line(node, errno);
    return port;
}

class SerialLineSource final : public ReportSource {
public:
    SerialLineSource(DeviceInfo info, SerialPort port)
        : info_(std::move(info))
        , port_(std::move(port))
    {
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override;
    std::uint64_t oversized_count() const override { return too_long_; }

private:
    Result<void> read_some(Duration timeout);
    void take_byte(char byte, Timestamp now);
    tl::unexpected<Error> gone() const
    {
        return fail(Fault::Device, fmt::format("{} at {} is gone", info_.name, info_.location));
    }

    DeviceInfo info_;
    SerialPort port_;
    std::deque<RawReport> lines_; // Complete lines waiting to be read.
    RawReport line_ {};           // Line being received.
    bool is_whole_ = false;       // True if line_ was received from its beginning.
    bool is_too_long_ = false;    // True if line_ exceeds a report.
    std::uint64_t too_long_ = 0;
};

void SerialLineSource::take_byte(char byte, Timestamp now)
{
    if (byte != '\n') {
        is_too_long_ |= line_.size == line_.storage.size();
        if (!is_too_long_)
            line_.storage[line_.size++] = static_cast<std::byte>(byte);
        return;
    }
    if (line_.size > 0 && line_.storage[line_.size - 1] == std::byte { '\r' })
        --line_.size;
    line_.received = now;
    if (is_too_long_)
        ++too_long_;
    else if (is_whole_ && line_.size > 0)
        lines_.push_back(line_);
    line_.size = 0;
    is_whole_ = true;
    is_too_long_ = false;
}

Result<void> SerialLineSource::read_some(Duration timeout)
{
    pollfd waiting { .fd = port_.file(), .events = POLLIN, .revents = 0 };
    auto const wait = std::chrono::ceil<std::chrono::milliseconds>(std::max(timeout, Duration(0)));
    auto const ready
        = ::poll(&waiting, 1, static_cast<int>(std::min<std::int64_t>(wait.count(), 1000)));
    if (ready < 0 && errno != EINTR)
        return gone();
    if (ready <= 0)
        return {};
    std::array<char, 1024> bytes {};
    auto const size = ::read(port_.file(), bytes.data(), bytes.size());
    if (size < 0 && (errno == EAGAIN || errno == EINTR))
        return {};
    if (size <= 0)
        return gone();
    auto const now = monotonic_now();
    for (auto const byte : std::span(bytes).first(static_cast<std::size_t>(size)))
        take_byte(byte, now);
    return {};
}

Result<std::optional<RawReport>> SerialLineSource::read(Duration timeout)
{
    auto const end = monotonic_now() + timeout;
    while (lines_.empty()) {
        auto const left = end - monotonic_now();
        TRY(read_some(left));
        if (lines_.empty() && left <= Duration(0))
            return std::optional<RawReport>();
    }
    auto const line = lines_.front();
    lines_.pop_front();
    return std::optional(line);
}

// Returns the USB device of a tty, whose folder is …/1-2/1-2:1.0/tty/ttyACM0 or
// …/1-2:1.0/ttyUSB0/tty/….
std::optional<fs::path> usb_device_of(fs::path const& tty)
{
    std::error_code error;
    auto folder = fs::canonical(tty / "device", error);
    for (int levels = 0; !error && levels < 3; ++levels, folder = folder.parent_path())
        if (fs::exists(folder / "idVendor", error))
            return folder;
    return std::nullopt;
}

DeviceInfo describe_tty(std::string const& node, std::optional<fs::path> const& usb)
{
    DeviceInfo info { .name = "serial line", .location = node };
    if (!usb)
        return info;
    info.manufacturer = read_sysfs_line(*usb / "manufacturer");
    info.serial_number = read_sysfs_line(*usb / "serial");
    if (auto product = read_sysfs_line(*usb / "product"); !product.empty())
        info.name = std::move(product);
    info.vendor_id = static_cast<std::uint16_t>(read_sysfs_number(*usb / "idVendor", 16));
    info.product_id = static_cast<std::uint16_t>(read_sysfs_number(*usb / "idProduct", 16));
    return info;
}

} // namespace

std::vector<DeviceInfo> list_serial_lines(fs::path const& tty_folder)
{
    std::vector<DeviceInfo> lines;
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(tty_folder, error)) {
        auto const name = entry.path().filename().string();
        if (name.starts_with("ttyACM") || name.starts_with("ttyUSB"))
            lines.push_back(describe_tty("/dev/" + name, usb_device_of(entry.path())));
    }
    std::ranges::sort(lines, {}, &DeviceInfo::location);
    return lines;
}

Result<DeviceInfo> describe_serial_line(std::string const& node)
{
    std::error_code error;
    auto const real = fs::canonical(node, error);
    if (error)
        return fail(Fault::User, fmt::format("there is no serial line at {}", node));
    for (auto& info : list_serial_lines())
        if (info.location == real) {
            info.location = node;
            return std::move(info);
        }
    return describe_tty(node, std::nullopt);
}

Result<std::unique_ptr<ReportSource>> open_serial_line(DeviceInfo info)
{
    auto const settings = TRY(parse_serial_settings(info.settings));
    auto port = TRY(open_port(info.location, settings.speed));
    info.physical_path = number_line_path(kSerialKind, info);
    return std::make_unique<SerialLineSource>(std::move(info), std::move(port));
}

bool is_serial_line(DeviceInfo const& info)
{
    return number_line_settings(kSerialKind, info).has_value();
}

Result<std::unique_ptr<HeightDecoder>> make_serial_line_decoder(DeviceInfo const& info)
{
    auto const settings = number_line_settings(kSerialKind, info).value_or(std::string());
    return make_number_decoder(TRY(parse_serial_settings(settings)).numbers);
}

} // namespace tractus::drivers
