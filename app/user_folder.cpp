#include "app/user_folder.h"

#include <cstdlib>
#include <fmt/core.h>
#include <string_view>
#include <system_error>

namespace tractus {

namespace fs = std::filesystem;

fs::path user_folder()
{
    // The specification lets only absolute paths count.
    auto const folder = [](char const* variable) -> fs::path {
        char const* const value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nobody
                                                         // changes the environment.
        return value != nullptr && *value == '/' ? value : "";
    };
    if (auto const data = folder("XDG_DATA_HOME"); !data.empty())
        return data / "tractus";
    auto const home = folder("HOME");
    return home.empty() ? home : home / ".local" / "share" / "tractus";
}

Result<fs::path> make_user_folder(std::string_view instead)
{
    auto const folder = user_folder();
    if (folder.empty())
        return fail(Fault::User, fmt::format("there is no home folder: {}", instead));
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail(Fault::User,
                    fmt::format("cannot make the folder {}: {}; {}", folder.string(),
                                error.message(), instead));
    return folder;
}

fs::path user_rig_path()
{
    auto const folder = user_folder();
    return folder.empty() ? folder : folder / "table.rig.toml";
}

} // namespace tractus
