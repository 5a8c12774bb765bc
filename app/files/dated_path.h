#pragma once

#include <chrono>
#include <filesystem>
#include <string_view>

namespace tractus::files {

// A new file's name that nobody has to type: FOLDER/PLANT-YYYY-MM-DD-HHMMSS.ENDING, in local time,
// with -2, -3 and so on before the ending where such a file is there already. `plant` is a model's
// name, of which the stem counts; `ending` begins with a dot, or with what else the name should
// say: "-seed-3.png". Makes no file.
std::filesystem::path dated_path(std::filesystem::path const& folder, std::string_view plant,
                                 std::string_view ending, std::chrono::sys_seconds now);

// Returns such a path named after the present.
std::filesystem::path dated_path(std::filesystem::path const& folder, std::string_view plant,
                                 std::string_view ending);

} // namespace tractus::files
