#include "app/user_folder.h"

#include <cstdlib>
#include <fmt/core.h>
#include <string_view>
#include <system_error>

namespace tractus {

namespace fs = std::filesystem;

static fs::path folder_in(char const* variable)
{
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody changes the environment.
    char const* const value = std::getenv(variable);
    // The specification lets only absolute paths count.
    return value != nullptr && *value == '/' ? value : "";
}

// The program's own folder in that which the variable names, else in one of the home folder.
static fs::path own_folder(char const* variable, char const* in_home)
{
    if (auto const named = folder_in(variable); !named.empty())
        return named / "tractus";
    auto const home = folder_in("HOME");
    return home.empty() ? home : home / in_home / "tractus";
}

fs::path user_folder()
{
    return own_folder("XDG_DATA_HOME", ".local/share");
}

fs::path user_cache_folder()
{
    return own_folder("XDG_CACHE_HOME", ".cache");
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
