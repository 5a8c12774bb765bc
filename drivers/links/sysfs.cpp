#include "drivers/links/sysfs.h"

#include "engine/base/file.h"

#include <charconv>

namespace tractus::drivers {

namespace fs = std::filesystem;

std::string read_sysfs_line(fs::path const& file)
{
    auto text = read_file(file).value_or(std::string());
    text.resize(std::min(text.find('\n'), text.size()));
    while (text.ends_with(' '))
        text.pop_back();
    return text;
}

int read_sysfs_number(fs::path const& file, int base, int otherwise)
{
    auto const text = read_sysfs_line(file);
    std::from_chars(text.data(), text.data() + text.size(), otherwise, base);
    return otherwise;
}

std::string read_sysfs_link(fs::path const& link)
{
    std::error_code ignored;
    return fs::read_symlink(link, ignored).filename().string();
}

} // namespace tractus::drivers
