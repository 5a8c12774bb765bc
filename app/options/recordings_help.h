#pragma once

namespace tractus::options {

// The recordings that every command reads (drivers::read_log()), for its help.
constexpr char const* kRecordings = "a .tractus-log, or what hid-recorder, usbhid-dump, libinput "
                                    "record or evemu-record wrote";

} // namespace tractus::options
