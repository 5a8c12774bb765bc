#include "app/controllers/live_rig.h"

#include "calib/rig_file.h"
#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::controllers {

static bool has_pen(devices::LiveDevices const& devices)
{
    return std::any_of(devices.infos().begin(), devices.infos().end(), [](auto const& info) {
        return drivers::make_pen_decoder(info).has_value();
    });
}

// Returns the traits of the first tablet among the devices; nullopt if there is none.
static std::optional<drivers::PenTraits> first_tablet(devices::LiveDevices const& devices)
{
    for (auto const& info : devices.infos())
        if (auto const decoder = drivers::make_pen_decoder(info))
            return (*decoder)->traits();
    return std::nullopt;
}

bool has_height_sensor(devices::LiveDevices const& devices)
{
    return std::any_of(devices.infos().begin(), devices.infos().end(), [](auto const& info) {
        return !drivers::make_pen_decoder(info) && drivers::make_height_decoder(info);
    });
}

MouseParts add_mouse(devices::LiveDevices& devices, LiveWindowOptions const& options)
{
    // Initial height of the surface. It is above the controller, so that the part of the plant
    // below the surface is visible.
    constexpr double kFirstSurface_mm = 100;
    if (!options.mouse)
        return MouseParts {};
    MouseParts const parts { .pen = !has_pen(devices), .height = !has_height_sensor(devices) };
    auto mouse = *options.mouse;
    if (parts.pen)
        devices.add_source_without_thread(mouse.open_tablet());
    if (parts.height) {
        mouse.set_surface(options.height_mm.value_or(kFirstSurface_mm));
        devices.add_source_without_thread(mouse.open_height());
    }
    return parts;
}

bool lacks_calibration(devices::LiveDevices const& devices, LiveWindowOptions const& options)
{
    return !options.rig && devices.rig_text().empty() && !options.height_mm
        && has_height_sensor(devices);
}

Result<calib::Rig> choose_rig(devices::LiveDevices const& devices, LiveWindowOptions const& options,
                              MouseParts const& mouse)
{
    if (mouse.pen && mouse.height)
        return MouseRig::rig();
    if (mouse.height) {
        auto rig = options.rig.value_or(
            calib::Rig { .tablet_size_mm = first_tablet(devices).value().size_mm });
        MouseRig::set_height_sensor_in(rig);
        return rig;
    }
    if (options.rig)
        return *options.rig;
    if (!devices.rig_text().empty())
        return calib::parse_rig(devices.rig_text(), "the log's rig");
    if (lacks_calibration(devices, options) && options.rig_file.empty())
        return fail(Fault::User,
                    "there is a height sensor but no calibration of it: give one with --rig, or "
                    "the surface's height with --height");
    calib::Rig rig;
    if (auto const tablet = first_tablet(devices))
        rig.tablet_size_mm = tablet->size_mm;
    return rig;
}

std::optional<std::string> size_note(devices::LiveDevices const& devices, calib::Rig const& rig)
{
    auto const tablet = first_tablet(devices);
    if (rig.surface_mm || !tablet || !tablet->is_size_assumed)
        return std::nullopt;
    return fmt::format("The tablet does not tell its size, and {:.0f} x {:.0f} mm is a guess: "
                       "\"tractus doctor\" asks for it",
                       rig.tablet_size_mm.x(), rig.tablet_size_mm.y());
}

} // namespace tractus::controllers
