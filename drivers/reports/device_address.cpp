#include "drivers/reports/device_address.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <optional>

namespace tractus::drivers {

namespace {

// Maximum number of ports in the path to a device: USB 2.0, section 4.1.1, allows seven tiers.
constexpr std::size_t kMaxPorts = 7;
constexpr std::string_view kNodes = "/dev/hidraw";
constexpr std::string_view kEventNodes = "/dev/input/event";
constexpr std::string_view kQuadrature = ":quadrature";

tl::unexpected<Error> not_an_address(std::string_view text, std::string_view expected)
{
    return fail(Fault::User,
                fmt::format("'{}' is not the address of a device: expected {}", text, expected));
}

// Parses the whole text as a decimal number that is not negative.
std::optional<int> number(std::string_view text)
{
    int value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0)
        return std::nullopt;
    return value;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        auto const end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

// Removes the part after the last separator from the text and returns it; returns an empty text if
// there is no separator.
std::string_view take_last(std::string_view& text, char separator)
{
    auto const at = text.rfind(separator);
    if (at == std::string_view::npos)
        return {};
    auto const last = text.substr(at + 1);
    text = text.substr(0, at);
    return last;
}

std::optional<UsbPort> parse_port(std::string_view text)
{
    auto const dash = text.find('-');
    auto const bus = number(text.substr(0, dash));
    if (dash == std::string_view::npos || !bus || *bus == 0)
        return std::nullopt;
    UsbPort port { .bus = *bus };
    for (auto const part : split(text.substr(dash + 1), '.')) {
        auto const value = number(part);
        if (!value || *value == 0 || port.ports.size() == kMaxPorts)
            return std::nullopt;
        port.ports.push_back(*value);
    }
    return port;
}

Result<DeviceAddress> parse_libusb(std::string_view text, std::string_view rest)
{
    auto const interface_number = number(take_last(rest, ':'));
    auto const port = parse_port(rest);
    if (!interface_number || !port)
        return not_an_address(text, "libusb:BUS-PORTS:INTERFACE, such as libusb:1-2.3:0");
    return LibusbAddress { *port, *interface_number };
}

Result<DeviceAddress> parse_usb(std::string_view text, std::string_view rest)
{
    auto const port = parse_port(rest);
    if (!port)
        return not_an_address(text, "usb:BUS-PORTS, such as usb:1-2.3");
    return UsbAddress { *port };
}

// Parses `count` line numbers separated by commas.
template<std::size_t count>
std::optional<std::array<unsigned, count>> parse_lines(std::string_view text)
{
    auto const parts = split(text, ',');
    if (parts.size() != count)
        return std::nullopt;
    std::array<unsigned, count> lines {};
    for (std::size_t i = 0; i < count; ++i) {
        auto const line = number(parts[i]);
        if (!line)
            return std::nullopt;
        lines[i] = static_cast<unsigned>(*line);
    }
    return lines;
}

Result<DeviceAddress> parse_encoder(std::string_view text, std::string_view rest)
{
    auto const lines = parse_lines<2>(take_last(rest, ':'));
    if (!lines || rest.empty())
        return not_an_address(text,
                              "gpio:CHIP:A,B:quadrature, such as gpio:gpiochip0:17,27:quadrature");
    return GpioEncoderAddress { .chip = std::string(rest),
                                .a_line = (*lines)[0],
                                .b_line = (*lines)[1] };
}

// Parses the address from right to left, since a chip's label may contain colons.
Result<DeviceAddress> parse_gpio(std::string_view text, std::string_view rest)
{
    if (rest.ends_with(kQuadrature))
        return parse_encoder(text, rest.substr(0, rest.size() - kQuadrature.size()));
    auto const channel = number(take_last(rest, ':'));
    auto const converter = take_last(rest, ':');
    auto const lines = parse_lines<4>(take_last(rest, ':'));
    if (!lines || !channel || converter.empty() || rest.empty())
        return not_an_address(text,
                              "gpio:CHIP:CLK,DIN,DOUT,CS:CONVERTER:CHANNEL, such as "
                              "gpio:gpiochip0:11,10,9,8:mcp3208:0");
    return GpioAddress { .chip = std::string(rest),
                         .clk_line = (*lines)[0],
                         .din_line = (*lines)[1],
                         .dout_line = (*lines)[2],
                         .cs_line = (*lines)[3],
                         .converter = std::string(converter),
                         .channel = static_cast<unsigned>(*channel) };
}

Result<DeviceAddress> parse_iio(std::string_view text, std::string_view rest)
{
    auto const channel = take_last(rest, ':');
    auto const is_name = [](std::string_view part) {
        return !part.empty() && part.find('/') == std::string_view::npos && part != "..";
    };
    if (!is_name(channel) || !is_name(rest))
        return not_an_address(text, "iio:DEVICE:CHANNEL, such as iio:device0:voltage1");
    return IioAddress { .device = std::string(rest), .channel = std::string(channel) };
}

bool is_serial_node(std::string_view text)
{
    static constexpr std::array<std::string_view, 3> kSerialNodes { "/dev/tty", "/dev/serial/",
                                                                    "/dev/pts/" };
    return std::any_of(kSerialNodes.begin(), kSerialNodes.end(), [&](std::string_view begin) {
        return text.starts_with(begin) && text.size() > begin.size();
    });
}

std::string print(HidrawAddress const& address)
{
    return address.node;
}

std::string print(LibusbAddress const& address)
{
    return fmt::format("libusb:{}:{}", print_usb_port(address.port), address.interface_number);
}

std::string print(UsbAddress const& address)
{
    return fmt::format("usb:{}", print_usb_port(address.port));
}

std::string print(GpioAddress const& address)
{
    return fmt::format("gpio:{}:{},{},{},{}:{}:{}", address.chip, address.clk_line,
                       address.din_line, address.dout_line, address.cs_line, address.converter,
                       address.channel);
}

std::string print(GpioEncoderAddress const& address)
{
    return fmt::format("gpio:{}:{},{}{}", address.chip, address.a_line, address.b_line,
                       kQuadrature);
}

std::string print(SerialAddress const& address)
{
    return address.node;
}

std::string print(EventAddress const& address)
{
    return address.node;
}

std::string print(IioAddress const& address)
{
    return fmt::format("iio:{}:{}", address.device, address.channel);
}

} // namespace

Result<DeviceAddress> parse_device_address(std::string_view text)
{
    using Parser = Result<DeviceAddress> (*)(std::string_view, std::string_view);
    static constexpr std::array<std::pair<std::string_view, Parser>, 4> kParsers { {
        { "libusb:", parse_libusb },
        { "usb:", parse_usb },
        { "gpio:", parse_gpio },
        { "iio:", parse_iio },
    } };
    for (auto const& [prefix, parser] : kParsers)
        if (text.starts_with(prefix))
            return parser(text, text.substr(prefix.size()));
    if (text.starts_with(kNodes) && number(text.substr(kNodes.size())))
        return HidrawAddress { std::string(text) };
    if (text.starts_with(kEventNodes) && number(text.substr(kEventNodes.size())))
        return EventAddress { std::string(text) };
    if (is_serial_node(text))
        return SerialAddress { std::string(text) };
    return not_an_address(
        text,
        "/dev/hidrawN, libusb:BUS-PORTS:INTERFACE, usb:BUS-PORTS, /dev/ttyACM0 and the like, "
        "/dev/input/eventN, "
        "iio:DEVICE:CHANNEL, "
        "gpio:CHIP:CLK,DIN,DOUT,CS:CONVERTER:CHANNEL or gpio:CHIP:A,B:quadrature");
}

std::string print_device_address(DeviceAddress const& address)
{
    return std::visit([](auto const& kind) { return print(kind); }, address);
}

std::string print_usb_port(UsbPort const& port)
{
    return fmt::format("{}-{}", port.bus, fmt::join(port.ports, "."));
}

} // namespace tractus::drivers
