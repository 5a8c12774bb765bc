#pragma once

#include <string>
#include <vector>

namespace tractus::drivers {

// A library of the system that a driver stands on.
struct LibraryVersion {
    std::string name {}; // "hidapi"
    // The one that runs, or where it does not tell, that the program was built with.
    std::string version {};
    std::string needed {}; // The oldest that does all we ask of it.
};

std::vector<LibraryVersion> library_versions();

// Whether the first version, numbers with points between them, is the older one. What is no number
// counts as 0.
bool is_older_version(std::string const& version, std::string const& than);

} // namespace tractus::drivers
