#include "app/files/resources.h"
#include "engine/base/nearest_word.h"

#include <algorithm>
#include <dlfcn.h>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <link.h>

namespace tractus::files {

namespace fs = std::filesystem;

// Returns the shared library that contains this function, such as the Python module. Empty if the
// program itself contains it.
static fs::path library_of_this()
{
    static char const here = 0;
    Dl_info info {};
    void* map = nullptr;
    if (::dladdr1(&here, &info, &map, RTLD_DL_LINKMAP) == 0 || !map)
        return {};
    return static_cast<link_map const*>(map)->l_name; // Empty for the program itself.
}

// Returns PREFIX/share/tractus of the installed program PREFIX/bin/tractus, or of the installed
// module PREFIX/lib/pythonVERSION/dist-packages/tractus/FILE.
static fs::path installed_resources()
{
    std::error_code error;
    auto const library = library_of_this();
    if (library.empty()) {
        auto const program = fs::read_symlink("/proc/self/exe", error);
        return program.parent_path().parent_path() / "share" / "tractus";
    }
    auto const package = fs::absolute(library, error).parent_path();
    auto const prefix = package.parent_path().parent_path().parent_path().parent_path();
    return prefix / "share" / "tractus";
}

Result<fs::path> find_resource(std::string_view name)
{
    std::error_code error;
    auto const installed = installed_resources() / name;
    auto const source = fs::path(TRACTUS_SOURCE_DIR) / "app" / name;
    for (auto const& path : { installed, source })
        if (fs::exists(path, error))
            return path;
    return fail(Fault::User,
                fmt::format("cannot find {} at {} or {}: install the program again", name,
                            installed.string(), source.string()));
}

std::vector<std::string> resource_names(std::string_view folder, std::string_view ending)
{
    std::vector<std::string> names;
    std::error_code error;
    auto const found = find_resource(folder);
    if (!found)
        return names;
    for (auto const& entry : fs::directory_iterator(*found, error))
        if (entry.path().extension() == ending)
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> model_names()
{
    return resource_names("models", ".l");
}

Result<fs::path> find_model(std::string_view name)
{
    std::error_code error;
    if (fs::path const path(name); fs::is_regular_file(path, error))
        return path;
    auto const folder = TRY(find_resource("models"));
    auto const ours = folder / fmt::format("{}.l", name);
    if (name.find('/') == std::string_view::npos && fs::exists(ours, error))
        return ours;
    return fail(Fault::User,
                fmt::format("there is no model {}{}: give the path of an L-system file, or "
                            "one of {}",
                            name, did_you_mean(name, model_names()),
                            fmt::join(model_names(), ", ")));
}

Result<fs::path> find_plant(std::string_view name)
{
    if (name == "empty")
        return fs::path();
    return find_model(name);
}

} // namespace tractus::files
