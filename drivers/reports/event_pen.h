#pragma once

#include "drivers/reports/device_info.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Converts pens that Linux provides only as input events (Documentation/input/event-codes.rst) into
// HID pens: pens on I2C and SPI, those of Surface computers, and recordings by evemu and libinput.
// The events become reports of a HID pen, whose report descriptor is made from the device's
// declared abilities, so recordings, decoders and other programs need no second kind of pen.

// The range of an absolute axis (struct input_absinfo).
struct EventAxis {
    std::int32_t minimum = 0;
    std::int32_t maximum = 0;
    std::int32_t resolution = 0; // Counts per mm, or per radian of tilt; 0 if not known.
};

// Events that a device declares that it can send.
struct EventAbilities {
    std::set<std::uint16_t> keys {};            // Codes of type EV_KEY.
    std::map<std::uint16_t, EventAxis> axes {}; // Codes of type EV_ABS → ranges.
};

// True for a pen: two position axes, a stylus tool or its button, and touch or pressure.
// Touchscreens, touchpads, mice and a tablet's keys are not pens.
bool is_event_pen(EventAbilities const& abilities);

// Returns a HID 1.11 report descriptor for the pen's reports, with the usages of a digitizer pen.
// Physical lengths are declared only for axes whose resolution is known.
std::vector<std::byte> describe_event_pen(EventAbilities const& abilities);

// Converts the events of one device into the reports that describe_event_pen() describes.
class EventPen {
public:
    // `abilities` must be those of a pen (is_event_pen()).
    explicit EventPen(EventAbilities abilities);
    ~EventPen();
    EventPen(EventPen&&) noexcept;
    EventPen& operator=(EventPen&&) noexcept;

    // Handles one event, given as in struct input_event. Returns the report that it completes,
    // valid until the next call. The result is empty for events within a frame, for frames that are
    // not about the pen, and until the pen's position is known. After SYN_DROPPED, events are
    // ignored until the end of the frame. The caller pushes the device's initial state in the form
    // of events, too.
    std::span<std::byte const> push(std::uint16_t type, std::uint16_t code, std::int32_t value);

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns the path that is kept in DeviceInfo::physical_path and in logs for an event device:
// "evdev:" and the kernel's path. It marks reports as made by an EventPen, regardless of the
// device's ids.
std::string event_pen_path(std::string_view kernel_path);
bool has_event_pen_reports(DeviceInfo const& info);

} // namespace tractus::drivers
