#include "sim/file_descriptor.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

namespace tractus::sim {

void FileDescriptor::close()
{
    if (number_ >= 0)
        ::close(std::exchange(number_, -1));
}

Result<FileDescriptor> open_kernel_file(std::filesystem::path const& path, int flags,
                                        std::string_view remedy)
{
    FileDescriptor file(::open(path.c_str(), flags | O_CLOEXEC));
    if (!file)
        return fail(
            Fault::User,
            fmt::format("cannot open {}: {} ({})", path.string(), std::strerror(errno), remedy));
    return file;
}

} // namespace tractus::sim
