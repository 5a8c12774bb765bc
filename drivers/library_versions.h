#pragma once

#include <string>
#include <vector>

namespace tractus::drivers {

// A system library that a driver uses.
struct LibraryVersion {
    std::string name {}; // Name, such as "hidapi".
    // Version at run time; where the library does not report it, the version at build time.
    std::string version {};
    std::string needed {}; // The oldest version with every function that the drivers call.
};

std::vector<LibraryVersion> library_versions();

// True if the first version is older than the second. A version is numbers separated by points;
// parts that are not numbers count as 0.
bool is_older_version(std::string const& version, std::string const& than);

} // namespace tractus::drivers
