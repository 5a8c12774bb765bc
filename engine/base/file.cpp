#include "engine/base/file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
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
    if (type == fs::file_type::character || type == fs::file_type::block) // /dev/zero has no end.
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
    // A text without a mark begins with a letter, which has a zero beside it.
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

// Devices and pipes are there already, and are neither whole nor half: /dev/stdout, /dev/full.
static bool is_stream(fs::path const& path)
{
    std::error_code ignored;
    auto const status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Remembers a temporary file for as long as it is unfinished, for the handler of a signal that ends
// the program. Each has a place of its own, which it takes and leaves in one step; where more are
// written at once than there are places, those beyond stay behind when a signal comes.
class Unfinished {
public:
    explicit Unfinished(fs::path const& written)
    {
        auto const& name = written.native();
        if (name.size() >= Place().path.size())
            return;
        for (auto& place : places) {
            auto free = Use::Free;
            if (!place.use.compare_exchange_strong(free, Use::Taken))
                continue;
            std::copy_n(name.c_str(), name.size() + 1, place.path.begin());
            place.use = Use::Named;
            mine_ = &place;
            return;
        }
    }
    ~Unfinished()
    {
        if (mine_ != nullptr)
            mine_->use = Use::Free;
    }
    Unfinished(Unfinished const&) = delete;
    Unfinished& operator=(Unfinished const&) = delete;

    // Only what a signal handler may do.
    static void remove_all()
    {
        for (auto const& place : places)
            if (place.use == Use::Named)
                ::unlink(place.path.data());
    }

private:
    enum class Use { Free, Taken, Named };
    struct Place {
        std::atomic<Use> use = Use::Free;
        std::array<char, 1024> path {};
    };
    static_assert(std::atomic<Use>::is_always_lock_free, "a signal's handler may use nothing else");

    static std::array<Place, 32> places;
    Place* mine_ = nullptr;
};

std::array<Unfinished::Place, 32> Unfinished::places {};

static void remove_unfinished_and_die(int signal)
{
    Unfinished::remove_all();
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void remove_unfinished_file_on_signals()
{
    for (int const signal : { SIGINT, SIGTERM, SIGHUP })
        if (std::signal(signal, remove_unfinished_and_die) == SIG_IGN)
            std::signal(signal, SIG_IGN); // Whoever started the program wants it so: nohup.
}

// Lets the disk take what was written to a file, or to a folder: its names. 0, or the error.
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

// The new name must not be on the disk before the bytes are, nor be lost afterwards.
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

// Begins a file that will take another's place with the other's permissions, so that nobody can
// read it who could not before: 0600 stays 0600. Where this fails, writing will say why.
static void begin_with_permissions_of(fs::path const& path, fs::path const& written)
{
    struct stat before { };
    if (::stat(path.c_str(), &before) != 0)
        return;
    mode_t const mode = before.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
    int const file = ::open(written.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file < 0)
        return;
    ::fchmod(file, mode | S_IWUSR); // Past the umask; the writer has to open it once more.
    ::close(file);
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
            return failed(errno); // The disk's reason is better than the writer's.
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

// Returns the path that a path leads to, though the last link may lead to what is not there yet.
static fs::path follow_links(fs::path path)
{
    constexpr int kMostLinks = 40; // The kernel allows as many.
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

// Why a folder takes no new file, as an error number; 0 if it takes one. Tried, since permissions
// do not tell all: with a file that never has a name, or where the file system knows none, with one
// that is there for a moment.
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

// A name that no other writer has, in this program or another.
static fs::path unfinished_path(fs::path const& target)
{
    static std::atomic<unsigned> count = 0;
    return fmt::format("{}.{}-{}.part", target.string(), ::getpid(), count++);
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
