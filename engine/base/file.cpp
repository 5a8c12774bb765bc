#include "engine/base/file.h"

#include "engine/base/unfinished_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace tractus {

namespace fs = std::filesystem;

Result<void> read_file_in_pieces(fs::path const& path, std::size_t max_bytes,
                                 std::function<Result<void>(std::string_view)> const& take)
{
    std::error_code ignored;
    auto const type = fs::status(path, ignored).type();
    if (type == fs::file_type::directory)
        return fail(Fault::User, fmt::format("cannot read {}: it is a folder", path.string()));
    // A device such as /dev/zero may never end.
    if (type == fs::file_type::character || type == fs::file_type::block)
        return fail(Fault::User, fmt::format("cannot read {}: it is a device", path.string()));
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return fail(Fault::User,
                    fmt::format("cannot open {}: {}", path.string(), std::strerror(errno)));
    std::string piece(std::size_t { 1 } << 16, '\0');
    std::size_t size = 0;
    while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0) {
        auto const count = static_cast<std::size_t>(in.gcount());
        size += count;
        if (size > max_bytes)
            return fail(Fault::User,
                        fmt::format("cannot read {}: it is larger than {} bytes", path.string(),
                                    max_bytes));
        TRY(take(std::string_view(piece).substr(0, count)));
    }
    if (in.bad())
        return fail(Fault::User,
                    fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
    return {};
}

Result<std::string> read_file(fs::path const& path, std::size_t max_bytes)
{
    std::string bytes;
    TRY(read_file_in_pieces(path, max_bytes, [&](std::string_view piece) -> Result<void> {
        bytes.append(piece);
        return {};
    }));
    return bytes;
}

Result<void> refuse_wide_text(std::string_view bytes, std::string_view name)
{
    constexpr std::string_view kLittleMark = "\xFF\xFE";
    constexpr std::string_view kBigMark = "\xFE\xFF";
    auto const begin = bytes.substr(0, 4);
    // UTF-16 and UTF-32 text without a byte order mark begins with a letter and therefore has a
    // zero byte among its first four.
    bool const has_zero = begin.size() == 4 && begin.find('\0') != std::string_view::npos
        && begin != std::string_view("\0\0\0\0", 4);
    if (!begin.starts_with(kLittleMark) && !begin.starts_with(kBigMark) && !has_zero)
        return {};
    return fail(Fault::User,
                fmt::format("{} is text in UTF-16 or UTF-32: save it again as UTF-8", name));
}

Result<std::string> read_text_file(fs::path const& path, std::size_t max_bytes)
{
    auto text = TRY(read_file(path, max_bytes));
    TRY(refuse_wide_text(text, path.string()));
    return text;
}

// True for devices and pipes such as /dev/stdout or /dev/full, which a rename cannot replace.
static bool is_stream(fs::path const& path)
{
    std::error_code ignored;
    auto const status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Flushes a file's contents, or a folder's entries, to the disk. Returns 0 or the error number.
static int flush_to_disk(fs::path const& path)
{
    int const file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return errno;
    int const error = ::fsync(file) == 0 ? 0 : errno;
    ::close(file);
    return error;
}

void flush_name_to_disk(fs::path const& path)
{
    flush_to_disk(path.has_parent_path() ? path.parent_path() : fs::path("."));
}

// Renames `written` to `path`. Flushes the file before the rename, so that the new name never
// refers to incomplete data, and the folder after it, so that the rename is not lost. Returns 0 or
// the error number.
static int put_in_place(fs::path const& written, fs::path const& path)
{
    if (int const error = flush_to_disk(written))
        return error;
    std::error_code error;
    fs::rename(written, path, error);
    if (!error)
        flush_name_to_disk(path);
    return error.value();
}

Result<void> rename_on_disk(fs::path const& from, fs::path const& to)
{
    if (int const error = put_in_place(from, to))
        return fail(Fault::User,
                    fmt::format("cannot write {}: {}", to.string(), std::strerror(error)));
    return {};
}

// Creates the replacement `written` of the file `path` with the permissions of that file, so that a
// file with mode 0600 is never readable by others. Errors are ignored: writing will report them.
static void begin_with_permissions_of(fs::path const& path, fs::path const& written)
{
    struct stat before { };
    if (::stat(path.c_str(), &before) != 0)
        return;
    mode_t const mode = before.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
    int const file = ::open(written.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file < 0)
        return;
    // Sets the mode regardless of the umask. The owner's write bit is needed to open the file
    // again.
    ::fchmod(file, mode | S_IWUSR);
    ::close(file);
}

// Writes to `written`, then renames it to `path`. The two are the same for a device or a pipe.
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

    std::optional<UnfinishedFile> unfinished;
    if (written != path) {
        unfinished.emplace(written);
        begin_with_permissions_of(path, written);
    }
    errno = 0;
    std::ofstream out(written, std::ios::binary | std::ios::trunc);
    if (!out)
        return failed(errno);
    if (auto result = write(out); !result) {
        out.close();
        if (!out.good())
            // The disk's error explains more than the writer's.
            return failed(errno);
        discard();
        return result;
    }
    out.close();
    if (!out)
        return failed(errno);
    if (written == path)
        return {};
    if (int const error = put_in_place(written, path))
        return failed(error);
    return {};
}

// Resolves the symbolic links of a path, even if the last one points to a file that does not exist.
static fs::path follow_links(fs::path path)
{
    constexpr int kMaxLinks = 40; // The same limit as the kernel's.
    std::error_code error;
    for (int i = 0; i < kMaxLinks && fs::is_symlink(path, error); ++i)
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

// Returns the error number with which a folder refuses a new file, or 0 if it accepts one. Found by
// trying, since permissions alone do not decide: creates an unnamed temporary file or, where the
// file system does not support these, a named file that is removed at once.
static int new_file_refusal(fs::path const& folder)
{
    int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
        auto name = (folder / ".tractus-XXXXXX").string();
        file = ::mkostemp(name.data(), O_CLOEXEC);
        if (file >= 0)
            ::unlink(name.c_str());
    }
    if (file < 0)
        return errno;
    ::close(file);
    return 0;
}

Result<void> check_writable(fs::path const& path)
{
    if (is_stream(path))
        return {};
    std::error_code error;
    if (fs::is_directory(path, error))
        return fail(Fault::User, fmt::format("cannot write {}: it is a folder", path.string()));
    auto folder = follow_links(path).parent_path();
    while (!folder.empty() && !fs::exists(folder, error))
        folder = folder.parent_path();
    if (folder.empty())
        folder = ".";
    if (!fs::is_directory(folder, error))
        return fail(
            Fault::User,
            fmt::format("cannot write {}: {} is no folder", path.string(), folder.string()));
    if (auto const refusal = new_file_refusal(folder); refusal != 0)
        return fail(Fault::User,
                    fmt::format("cannot write {}: in {}: {}", path.string(), folder.string(),
                                std::strerror(refusal)));
    return {};
}

Result<void> write_file(fs::path const& path,
                        std::function<Result<void>(std::ostream&)> const& write)
{
    if (is_stream(path))
        return write_and_rename(path, path, write);
    auto const target = follow_links(path);
    if (target.has_parent_path())
        TRY(make_folder(target.parent_path()));
    return write_and_rename(target, unfinished_path(target), write);
}

Result<void> write_file(fs::path const& path, std::string_view bytes)
{
    return write_file(path, [&](std::ostream& out) -> Result<void> {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return {};
    });
}

} // namespace tractus
