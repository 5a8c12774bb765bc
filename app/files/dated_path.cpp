#include "app/files/dated_path.h"

#include <fmt/chrono.h>
#include <fmt/core.h>

namespace tractus::files {

namespace fs = std::filesystem;

fs::path dated_path(fs::path const& folder, std::string_view plant, std::string_view ending,
                    std::chrono::sys_seconds now)
{
    auto const stem = fs::path(plant).stem().string();
    auto const name = fmt::format("{}-{:%Y-%m-%d-%H%M%S}", stem.empty() ? "plant" : stem,
                                  fmt::localtime(std::chrono::system_clock::to_time_t(now)));
    auto path = folder / fmt::format("{}{}", name, ending);
    std::error_code ignored;
    for (int number = 2; fs::exists(path, ignored); ++number)
        path = folder / fmt::format("{}-{}{}", name, number, ending);
    return path;
}

fs::path dated_path(fs::path const& folder, std::string_view plant, std::string_view ending)
{
    return dated_path(folder, plant, ending,
                      std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
}

} // namespace tractus::files
