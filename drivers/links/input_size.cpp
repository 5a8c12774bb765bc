#include "drivers/links/input_size.h"

#include "drivers/links/udev_handles.h"

#include <charconv>
#include <string_view>
#include <system_error>

namespace tractus::drivers {

namespace {

namespace fs = std::filesystem;

std::string_view property(udev_device* device, char const* name)
{
    auto const* const value = udev_device_get_property_value(device, name);
    return value ? value : "";
}

// Parses the side of a tablet. No value if it is implausible.
std::optional<double> side_mm(std::string_view text)
{
    constexpr int kMin = 20;
    constexpr int kMax = 2000;
    int value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < kMin || value > kMax)
        return std::nullopt;
    return value;
}

std::optional<Vec2> pen_size(udev* context, fs::path const& event_folder)
{
    std::unique_ptr<udev_device, UdevUnreference> const device(
        udev_device_new_from_syspath(context, event_folder.c_str()));
    if (!device || property(device.get(), "ID_INPUT_TABLET") != "1"
        || property(device.get(), "ID_INPUT_TABLET_PAD") == "1"
        || property(device.get(), "ID_INPUT_TOUCHPAD") == "1")
        return std::nullopt;
    auto const width = side_mm(property(device.get(), "ID_INPUT_WIDTH_MM"));
    auto const height = side_mm(property(device.get(), "ID_INPUT_HEIGHT_MM"));
    if (!width || !height)
        return std::nullopt;
    return Vec2(*width, *height);
}

} // namespace

std::optional<Vec2> size_known_to_udev(fs::path const& hidraw_folder)
{
    std::unique_ptr<udev, UdevUnreference> const context(udev_new());
    if (!context)
        return std::nullopt;
    // An error means that the device has no inputs or has just been removed.
    std::error_code ignored;
    auto const inputs = fs::canonical(hidraw_folder / "device", ignored) / "input";
    for (fs::recursive_directory_iterator entry(inputs, ignored), end; entry != end;
         entry.increment(ignored)) {
        if (entry.depth() > 0) // Looks no deeper than "input7/event3".
            entry.disable_recursion_pending();
        if (entry->path().filename().string().starts_with("event"))
            if (auto const size_mm = pen_size(context.get(), entry->path()))
                return size_mm;
    }
    return std::nullopt;
}

} // namespace tractus::drivers
