#pragma once

#include "drivers/reports/device_info.h"

#include <string>
#include <string_view>

namespace tractus::diagnosis {

// Content of drivers/70-tractus.rules at build time.
std::string_view udev_rules_text();

// Users whom the rules permit to use the devices.
enum class RuleHolder {
    Seat,  // The user at the screen.
    Group, // Members of the group plugdev, also over ssh.
};

// The rules file that permits these users to use the devices.
std::string udev_rules(RuleHolder holder);

// True if the rules, once installed, permit this device.
bool do_rules_permit(drivers::DeviceInfo const& info);

// A one-line rule that permits this device and no other model.
std::string udev_rule_for(drivers::DeviceInfo const& info);

} // namespace tractus::diagnosis
