#pragma once

namespace tractus::options {

// Names the kinds of recordings that drivers::read_log() reads, for the help texts of all commands.
constexpr char const* kRecordings = "a .tractus-log, or what hid-recorder, usbhid-dump, libinput "
                                    "record or evemu-record wrote";

} // namespace tractus::options
