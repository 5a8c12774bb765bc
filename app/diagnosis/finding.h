#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::diagnosis {

// Kinds of problems with the hardware or its drivers.
enum class FindingKind {
    Fine,           // No problem.
    NoTablet,       // No tablet is connected.
    NotPermitted,   // The node exists but the user may not open it.
    NoDriver,       // The kernel knows the device, but no driver creates a node for it.
    DriverInTheWay, // A kernel driver occupies the device or interferes.
    MouseMode,      // A tablet that reports mouse movements.
    UnknownTablet,  // A tablet with an unsupported report format.
    BrokenReports,  // Reports that do not match the device's description.
    PenNeverLifts,  // A pen that touches whenever it is in range.
    SentTwice,      // A tablet that sends every report on two nodes.
    Silent,         // The device sends nothing.
    HeightFault,    // The height sensor is at its limit, stuck, jumps or falls silent.
    ClockJump,      // The clock jumped or went backwards.
    OldLibrary,     // A library is too old.
};

// The kind as one word for programs, such as "not-permitted".
std::string_view name_of(FindingKind kind);

// One finding on which the user can act.
struct Finding {
    FindingKind kind = FindingKind::Fine;
    std::string subject {}; // The device or place concerned: "Wacom CTL-472 at /dev/hidraw3".
    std::string what {};    // Sentence about the problem and its cause.
    // Steps to take, in order, one line each; commands and file contents are given literally.
    std::vector<std::string> remedy {};
    bool lacks_size = false; // A working tablet that does not report the size of its surface.
};

// True if any finding is a problem.
bool has_trouble(std::span<Finding const> findings);

// Formats findings for the user; print_findings_json() formats them as JSON.
std::string print_findings(std::span<Finding const> findings);
std::string print_findings_json(std::span<Finding const> findings);

} // namespace tractus::diagnosis
