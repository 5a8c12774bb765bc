#include "drivers/file.h"

#include <cerrno>
#include <cstring>
#include <fmt/core.h>
#include <unistd.h>

namespace tractus {

namespace fs = std::filesystem;

Result<std::string> read_file(fs::path const& path, std::size_t max_bytes)
{
    if (std::error_code ignored; fs::is_directory(path, ignored))
        return fail(Fault::User, fmt::format("cannot read {}: it is a folder", path.string()));
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return fail(Fault::User,
                    fmt::format("cannot open {}: {}", path.string(), std::strerror(errno)));
    std::string bytes;
    std::string chunk(std::size_t { 1 } << 16, '\0');
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
        bytes.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
        if (bytes.size() > max_bytes)
            return fail(Fault::User,
                        fmt::format("cannot read {}: it is larger than {} bytes", path.string(),
                                    max_bytes));
    }
    if (in.bad())
        return fail(Fault::User,
                    fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
    return bytes;
}

Result<void> write_file(fs::path const& path,
                        std::function<Result<void>(std::ostream&)> const& write)
{
    auto const temporary = fs::path(fmt::format("{}.{}.part", path.string(), ::getpid()));
    auto const failed = [&](int error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        return fail(Fault::User,
                    fmt::format("cannot write {}: {}", path.string(),
                                error ? std::strerror(error) : "the write failed"));
    };

    errno = 0;
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (!out)
        return failed(errno);
    if (auto result = write(out); !result) {
        out.close();
        if (out.good()) { // The writer's own reason; the disk's is better where there is one.
            std::error_code ignored;
            fs::remove(temporary, ignored);
            return result;
        }
        return failed(errno);
    }
    out.close();
    if (!out)
        return failed(errno);
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error)
        return failed(error.value());
    return {};
}

Result<void> write_file(fs::path const& path, std::string_view bytes)
{
    return write_file(path, [&](std::ostream& out) -> Result<void> {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return {};
    });
}

} // namespace tractus
