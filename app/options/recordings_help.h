#pragma once

namespace tractus::options {

// Names the kinds of recordings that every command reads (drivers::read_log()), for help texts.
constexpr char const* kRecordings = "a .tractus-log, or what hid-recorder, usbhid-dump, libinput "
                                    "record or evemu-record wrote";

} // namespace tractus::options
