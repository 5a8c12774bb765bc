#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::diagnosis {

// Troubles with the hardware and its way into the program.
enum class FindingKind {
    Fine,           // Nothing is.
    NoTablet,       // None is plugged in.
    NotPermitted,   // The node is there, but may not be opened.
    NoDriver,       // The kernel knows the device, and no driver makes a node of it.
    DriverInTheWay, // A driver of the kernel works against us.
    MouseMode,      // A tablet that reports a mouse's movements.
    UnknownTablet,  // A tablet whose reports nobody has described to us.
    BrokenReports,  // Reports that are not as the device announces them.
    PenNeverLifts,  // A pen that touches whenever it is in range.
    SentTwice,      // A tablet that sends each report on two nodes.
    Silent,         // Nothing comes.
    HeightFault,    // The height sensor is on a rail, stuck, jumps or falls silent.
    ClockJump,      // Times are not what they should be.
    OldLibrary,     // A library lacks what we need.
};

// The kind as one word for programs: "not-permitted".
std::string_view name_of(FindingKind kind);

// One thing that was found, for a person to act on.
struct Finding {
    FindingKind kind = FindingKind::Fine;
    std::string subject {}; // Device or place that it is about: "Wacom CTL-472 at /dev/hidraw3".
    std::string what {};    // A sentence: what is the matter, and why.
    // Steps to take, in this order, a line each: commands and file contents as they are to be
    // typed.
    std::vector<std::string> remedy {};
    bool lacks_size = false; // A tablet that works, and does not tell the size of its surface.
};

// Whether any of them is a trouble.
bool has_trouble(std::span<Finding const> findings);

// Findings as a person reads them, and as JSON.
std::string print_findings(std::span<Finding const> findings);
std::string print_findings_json(std::span<Finding const> findings);

} // namespace tractus::diagnosis
