#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tractus::controllers {

// A session in the list of recent drawings.
struct RecentDrawing {
    std::filesystem::path file {};
    std::string name {}; // Display name of the drawing; see name_of_drawing().
    std::string time {}; // Time of the last change, as time_in_words() formats it.
};

// Returns the sessions in a folder, the most recently changed first, at most `most`. The result is
// empty if the folder does not exist.
std::vector<RecentDrawing> recent_drawings(std::filesystem::path const& folder, std::size_t most,
                                           std::chrono::sys_seconds now);

// Returns the time at which a file was last written; for a session, this includes its write-ahead
// log.
std::chrono::sys_seconds modification_time(std::filesystem::path const& file);

// Formats a time in local time and relative to `now`: "Today, 14:03", "Yesterday, 9:12",
// "24 November, 18:40", "3 March 2025".
std::string time_in_words(std::chrono::sys_seconds time, std::chrono::sys_seconds now);

} // namespace tractus::controllers
