#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tractus::controllers {

// A session that somebody has drawn in.
struct RecentDrawing {
    std::filesystem::path file {};
    std::string name {}; // See name_of_drawing().
    std::string time {}; // When it was last drawn in: see time_in_words().
};

// The sessions of a folder, the one that was drawn in last first, at most so many. None where there
// is no such folder.
std::vector<RecentDrawing> recent_drawings(std::filesystem::path const& folder, std::size_t most,
                                           std::chrono::sys_seconds now);

// When a file was written last; of a session with what is not moved into it yet.
std::chrono::sys_seconds written_last(std::filesystem::path const& file);

// "Today, 14:03", "Yesterday, 9:12", "24 November, 18:40", "3 March 2025": in local time.
std::string time_in_words(std::chrono::sys_seconds time, std::chrono::sys_seconds now);

} // namespace tractus::controllers
