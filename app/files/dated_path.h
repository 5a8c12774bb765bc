#pragma once

#include <chrono>
#include <filesystem>
#include <string_view>

namespace tractus::files {

// Generates a file name FOLDER/PLANT-YYYY-MM-DD-HHMMSS.ENDING in local time. If such a file exists,
// -2, -3 and so on is inserted before the ending. `plant` is a model's name or path, of which only
// the stem is used. `ending` begins with a dot, or with more of the name, such as "-seed-3.png".
// Creates no file.
std::filesystem::path dated_path(std::filesystem::path const& folder, std::string_view plant,
                                 std::string_view ending, std::chrono::sys_seconds now);

// Returns dated_path() for the current time.
std::filesystem::path dated_path(std::filesystem::path const& folder, std::string_view plant,
                                 std::string_view ending);

} // namespace tractus::files
