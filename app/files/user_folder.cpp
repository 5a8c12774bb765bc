#include "app/files/user_folder.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/core.h>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace tractus::files {

namespace fs = std::filesystem;

static fs::path folder_in(char const* variable)
{
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the program never changes its environment.
    char const* const value = std::getenv(variable);
    // The XDG specification requires relative paths to be ignored.
    return value != nullptr && *value == '/' ? value : "";
}

// Returns the folder "tractus" in the folder that the environment variable names. If the variable
// names no absolute path, it is in $HOME/`in_home`.
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

// Returns a folder of the desktop from the text of user-dirs.dirs, which has lines such as
// XDG_PICTURES_DIR="$HOME/Bilder"; by default `usual` in the home folder.
static fs::path desktop_folder(std::string const& settings, std::string const& name,
                               fs::path const& home, char const* usual)
{
    auto const begin = "XDG_" + name + "_DIR=\"";
    auto const at = settings.find('\n' + begin);
    if (at == std::string::npos)
        return home / usual;
    auto const from = at + 1 + begin.size();
    auto const value = settings.substr(from, settings.find_first_of("\"\n", from) - from);
    constexpr std::string_view kHome = "$HOME/";
    return value.starts_with(kHome) ? home / value.substr(kHome.size()) : fs::path(value);
}

std::vector<fs::path> user_picture_folders()
{
    auto const home = folder_in("HOME");
    if (home.empty())
        return {};
    auto const named = folder_in("XDG_CONFIG_HOME");
    std::ifstream in((named.empty() ? home / ".config" : named) / "user-dirs.dirs");
    std::string settings("\n");
    for (std::string line; std::getline(in, line);)
        settings += line + '\n';
    std::vector<fs::path> folders;
    for (auto const& folder :
         { user_folder() / "pictures", desktop_folder(settings, "PICTURES", home, "Pictures"),
           desktop_folder(settings, "DOWNLOAD", home, "Downloads") })
        if (std::find(folders.begin(), folders.end(), folder) == folders.end())
            folders.push_back(folder);
    return folders;
}

fs::path user_rig_path()
{
    auto const folder = user_folder();
    return folder.empty() ? folder : folder / "table.rig.toml";
}

} // namespace tractus::files
