#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::diagnosis {

// Kind of problem with the hardware or its drivers.
enum class FindingKind {
    Fine,           // No problem.
    NoTablet,       // No tablet is connected.
    NotPermitted,   // The device node exists, but the user may not open it.
    NoDriver,       // The kernel knows the device, but no driver has created a node for it.
    DriverInTheWay, // A kernel driver occupies the device or interferes with it.
    MouseMode,      // A tablet reports mouse movements instead of a pen.
    UnknownTablet,  // A tablet has an unsupported report format.
    BrokenReports,  // Reports do not match the device's description.
    PenNeverLifts,  // A pen touches whenever it is in range.
    SentTwice,      // A tablet sends every report on two device nodes.
    Silent,         // The device sends nothing.
    HeightFault,    // The height sensor is at its limit, stuck, jumps, or has stopped sending.
    ClockJump,      // A clock of the machine jumped or went backwards.
    OldLibrary,     // A library is too old for some features.
};

// Returns the kind as one word for programs, such as "not-permitted".
std::string_view name_of(FindingKind kind);

// A finding of the diagnosis: a problem with its remedy, or a device that works.
struct Finding {
    FindingKind kind = FindingKind::Fine;
    // The device or place concerned, such as "Wacom CTL-472 at /dev/hidraw3".
    std::string subject {};
    std::string what {}; // Sentence that explains the problem and its cause.
    // Steps that solve the problem, in order, one line each. Commands and contents of files are
    // literal.
    std::vector<std::string> remedy {};
    // True for a working tablet that does not report the size of its surface.
    bool lacks_size = false;
};

// True if at least one finding is a problem.
bool has_trouble(std::span<Finding const> findings);

// Format findings: print_findings() as text for the user, print_findings_json() as JSON.
std::string print_findings(std::span<Finding const> findings);
std::string print_findings_json(std::span<Finding const> findings);

} // namespace tractus::diagnosis
