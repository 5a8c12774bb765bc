#pragma once

#include <filesystem>
#include <string>

namespace tractus::drivers {

// The kernel's small files in /sys, one value each. What cannot be read has none: a device's files
// go with it.

// The first line, without blanks at its end; empty if there is none.
std::string read_sysfs_line(std::filesystem::path const& file);

// A whole number of that base; `otherwise` if it is none.
int read_sysfs_number(std::filesystem::path const& file, int base, int otherwise = 0);

// The name of what a link points to, such as a device's driver; empty if there is none.
std::string read_sysfs_link(std::filesystem::path const& link);

} // namespace tractus::drivers
