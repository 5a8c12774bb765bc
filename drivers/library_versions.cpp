#include "drivers/library_versions.h"

#include "drivers/gpio/gpio_lines.h"

#include <charconv>
#include <fmt/core.h>
#include <hidapi.h>
#include <libusb.h>
#include <string_view>

namespace tractus::drivers {

std::vector<LibraryVersion> library_versions()
{
    auto const& usb = *libusb_get_version();
    return {
        // 0.10.0 is the first version with hid_get_input_report().
        { "hidapi", hid_version_str(), "0.10.0" },
        { "libusb", fmt::format("{}.{}.{}", usb.major, usb.minor, usb.micro), "1.0.22" },
        // 1.6 is the first version with drive and bias settings for each line.
        { "libgpiod", gpio_library_version(), "1.6" },
    };
}

// Reads the leading number of a version and removes it and the following point.
static int take_number(std::string_view& version)
{
    int value = 0;
    std::from_chars(version.data(), version.data() + version.size(), value);
    auto const point = version.find('.');
    version.remove_prefix(point == std::string_view::npos ? version.size() : point + 1);
    return value;
}

bool is_older_version(std::string const& version, std::string const& than)
{
    std::string_view a(version);
    std::string_view b(than);
    while (!a.empty() || !b.empty()) {
        int const number = take_number(a);
        int const other = take_number(b);
        if (number != other)
            return number < other;
    }
    return false;
}

} // namespace tractus::drivers
