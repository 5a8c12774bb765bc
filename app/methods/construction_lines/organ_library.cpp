#include "app/methods/construction_lines/organ_library.h"

#include "app/files/resources.h"
#include "engine/base/file.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>

namespace tractus::lines {

namespace fs = std::filesystem;

std::vector<std::string> organ_names()
{
    return files::resource_names("leaves", kOrganEnding);
}

Result<fs::path> own_organ_path(std::string const& name)
{
    auto const ours = organ_names();
    if (std::ranges::find(ours, name) == ours.end())
        return fail(Fault::User,
                    fmt::format("there is no leaf in three views \"{}\": give the path of a file "
                                "({}), or one of {}",
                                name.substr(0, 40), kOrganEnding, fmt::join(ours, ", ")));
    return TRY(files::find_resource("leaves")) / (name + kOrganEnding);
}

Result<OrganFile> load_organ(fs::path const& path)
{
    auto const text = TRY(read_text_file(path, std::size_t { 1 } << 20));
    return parse_organ(text, path.string());
}

bool names_organ(std::string const& name, fs::path const& folder_of_sketch)
{
    std::error_code error;
    fs::path const path(name);
    return path.extension() == kOrganEnding
        || (!path.has_extension() && !fs::exists(folder_of_sketch / path, error));
}

Result<OrganFile> load_named_organ(std::string const& name, fs::path const& folder_of_sketch)
{
    if (fs::path(name).extension() == kOrganEnding)
        return load_organ((folder_of_sketch / name).lexically_normal());
    return load_organ(TRY(own_organ_path(name)));
}

} // namespace tractus::lines
