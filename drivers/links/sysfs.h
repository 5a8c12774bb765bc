#pragma once

#include <filesystem>
#include <string>

namespace tractus::drivers {

// Readers for sysfs files, which hold one value each. Unreadable files give the default, because a
// device's files vanish with it.

// Returns the file's first line without trailing blanks; empty if unreadable.
std::string read_sysfs_line(std::filesystem::path const& file);

// Returns the file's integer in the given base; `otherwise` if unreadable.
int read_sysfs_number(std::filesystem::path const& file, int base, int otherwise = 0);

// Returns the last component of a link's target, such as a driver's name; empty if unreadable.
std::string read_sysfs_link(std::filesystem::path const& link);

} // namespace tractus::drivers
