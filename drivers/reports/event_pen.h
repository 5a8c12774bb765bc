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

// Pens that Linux gives as input events alone (Documentation/input/event-codes.rst): those on I2C
// and SPI, of the Surface, and what evemu and libinput record. Their events are put into reports of
// a HID pen, whose report descriptor is made from what the device says of itself. So recordings,
// decoders and other programs know no second kind of pen.

// The range of an absolute axis (struct input_absinfo).
struct EventAxis {
    std::int32_t minimum = 0;
    std::int32_t maximum = 0;
    std::int32_t resolution = 0; // Counts per mm, or per radian of tilt; 0: not known.
};

// What an event device says it sends.
struct EventAbilities {
    std::set<std::uint16_t> keys {};            // Codes of EV_KEY.
    std::map<std::uint16_t, EventAxis> axes {}; // By code of EV_ABS.
};

// Whether it is a pen: a place of two axes, a stylus or its button, and a touch or a pressure.
// Touchscreens, touchpads, mice and the keys of a tablet are none.
bool is_event_pen(EventAbilities const& abilities);

// Describes such a pen's reports as HID 1.11 does, with a digitizer pen's usages. Lengths are
// declared where the axes have a resolution.
std::vector<std::byte> describe_event_pen(EventAbilities const& abilities);

// Turns the events of one device into the reports that describe_event_pen() describes.
class EventPen {
public:
    // `abilities` must be a pen's.
    explicit EventPen(EventAbilities abilities);
    ~EventPen();
    EventPen(EventPen&&) noexcept;
    EventPen& operator=(EventPen&&) noexcept;

    // Takes one event: type, code and value of struct input_event. The report that it completes,
    // valid until the next call; empty for events within a frame, for frames that say nothing of
    // the pen, and until its place has been told. After SYN_DROPPED what comes is left out up to
    // the end of its frame. What the device was like before its first event is pushed likewise.
    std::span<std::byte const> push(std::uint16_t type, std::uint16_t code, std::int32_t value);

private:
    struct State;
    std::unique_ptr<State> state_;
};

// The kernel's path to an event device, as DeviceInfo::physical_path has it and a log keeps it:
// "evdev:" and the path of its own. It tells that the reports are an EventPen's, whatever the
// device's ids would say.
std::string event_pen_path(std::string_view kernel_path);
bool has_event_pen_reports(DeviceInfo const& info);

} // namespace tractus::drivers
