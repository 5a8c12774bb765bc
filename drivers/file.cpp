#include "drivers/file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fmt/core.h>
#include <optional>
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

// Devices and pipes are there already, and are neither whole nor half: /dev/stdout, /dev/full.
static bool is_stream(fs::path const& path)
{
    std::error_code ignored;
    auto const status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// The temporary file under way, for the handler of a signal that ends the program. One at a time is
// remembered: the files that matter are written one after another.
static std::array<char, 4096> unfinished_path {};
static std::atomic<bool> is_unfinished = false;

// Remembers a temporary file for as long as it is unfinished.
class Unfinished {
public:
    explicit Unfinished(fs::path const& written)
    {
        auto const& name = written.native();
        if (is_unfinished || name.size() >= unfinished_path.size())
            return;
        std::copy_n(name.c_str(), name.size() + 1, unfinished_path.begin());
        is_unfinished = is_mine_ = true;
    }
    ~Unfinished()
    {
        if (is_mine_)
            is_unfinished = false;
    }
    Unfinished(Unfinished const&) = delete;
    Unfinished& operator=(Unfinished const&) = delete;

private:
    bool is_mine_ = false;
};

// Only what a signal handler may do.
static void remove_unfinished_and_die(int signal)
{
    if (is_unfinished)
        ::unlink(unfinished_path.data());
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void remove_unfinished_file_on_signals()
{
    for (int const signal : { SIGINT, SIGTERM, SIGHUP })
        if (std::signal(signal, remove_unfinished_and_die) == SIG_IGN)
            std::signal(signal, SIG_IGN); // Whoever started the program wants it so: nohup.
}

// Writes to `written`, which becomes `path` by a rename unless it is the same.
static Result<void> write_and_rename(fs::path const& path, fs::path const& written,
                                     std::function<Result<void>(std::ostream&)> const& write)
{
    auto const discard = [&] {
        std::error_code ignored;
        if (written != path)
            fs::remove(written, ignored);
    };
    auto const failed = [&](int error) {
        discard();
        return fail(Fault::User,
                    fmt::format("cannot write {}: {}", path.string(),
                                error ? std::strerror(error) : "the write failed"));
    };

    std::optional<Unfinished> unfinished;
    if (written != path)
        unfinished.emplace(written);
    errno = 0;
    std::ofstream out(written, std::ios::binary | std::ios::trunc);
    if (!out)
        return failed(errno);
    if (auto result = write(out); !result) {
        out.close();
        if (!out.good())
            return failed(errno); // The disk's reason is better than the writer's.
        discard();
        return result;
    }
    out.close();
    if (!out)
        return failed(errno);
    std::error_code error;
    if (written != path)
        fs::rename(written, path, error);
    if (error)
        return failed(error.value());
    return {};
}

// What a path leads to, though the last link may lead to what is not there yet.
static fs::path follow_links(fs::path path)
{
    constexpr int kMostLinks = 40; // As the kernel allows.
    std::error_code error;
    for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i)
        path = path.parent_path() / fs::read_symlink(path, error);
    return path;
}

Result<void> make_folder(fs::path const& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail(Fault::User,
                    fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
    return {};
}

Result<void> write_file(fs::path const& path,
                        std::function<Result<void>(std::ostream&)> const& write)
{
    if (is_stream(path))
        return write_and_rename(path, path, write);
    auto const target = follow_links(path);
    return write_and_rename(target, fmt::format("{}.{}.part", target.string(), ::getpid()), write);
}

Result<void> write_file(fs::path const& path, std::string_view bytes)
{
    return write_file(path, [&](std::ostream& out) -> Result<void> {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return {};
    });
}

} // namespace tractus
