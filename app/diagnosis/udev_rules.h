#pragma once

#include "drivers/reports/device_info.h"

#include <string>
#include <string_view>

namespace tractus::diagnosis {

// Content of drivers/70-tractus.rules, embedded when the program was built.
std::string_view udev_rules_text();

// Users to whom udev rules give access to the devices.
enum class RuleHolder {
    Seat,  // The user who is logged in at the screen.
    Group, // Members of the group "plugdev", also when logged in by ssh.
};

// Returns the text of a rules file that gives these users access to the devices.
std::string udev_rules(RuleHolder holder);

// True if the program's rules, once installed, give access to this device.
bool do_rules_permit(drivers::DeviceInfo const& info);

// Returns a one-line rule that gives access to devices of this model only.
std::string udev_rule_for(drivers::DeviceInfo const& info);

} // namespace tractus::diagnosis
