#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tractus::controllers {

// A session in the list of recent ones.
struct RecentDrawing {
    std::filesystem::path file {};
    std::string name {}; // Display name of the drawing; see name_of_drawing().
    std::string time {}; // Time of the last change, from time_in_words().
};

// The sessions in a folder, most recently changed first, at most `most`; empty if there is no such
// folder.
std::vector<RecentDrawing> recent_drawings(std::filesystem::path const& folder, std::size_t most,
                                           std::chrono::sys_seconds now);

// When a file was last written; for a session, including its write-ahead log.
std::chrono::sys_seconds modification_time(std::filesystem::path const& file);

// A time relative to now, in local time: "Today, 14:03", "Yesterday, 9:12", "24 November, 18:40",
// "3 March 2025".
std::string time_in_words(std::chrono::sys_seconds time, std::chrono::sys_seconds now);

} // namespace tractus::controllers
