#pragma once

#include "drivers/reports/device_info.h"

#include <string>
#include <string_view>

namespace tractus::diagnosis {

// drivers/70-tractus.rules, as it was when the program was built.
std::string_view udev_rules_text();

// Who may use the devices.
enum class RuleHolder {
    Seat,  // Whoever sits at the screen.
    Group, // The members of the group plugdev, over ssh as well.
};

// The rules file for one of both.
std::string udev_rules(RuleHolder holder);

// Whether the rules permit this device, if they are installed.
bool do_rules_permit(drivers::DeviceInfo const& info);

// The one rule, in one line, that permits this device and no other model.
std::string udev_rule_for(drivers::DeviceInfo const& info);

} // namespace tractus::diagnosis
