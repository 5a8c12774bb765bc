#include "engine/base/unfinished_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fmt/core.h>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace tractus {

namespace fs = std::filesystem;

namespace {

// Removes decimal digits from the end of a name and returns their value; nullopt if there are none.
std::optional<long> take_number(std::string_view& name)
{
    auto const before = name.find_last_not_of("0123456789");
    auto const digits = before == std::string_view::npos ? name : name.substr(before + 1);
    long number = 0;
    auto const read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (digits.empty() || read.ec != std::errc())
        return std::nullopt;
    name.remove_suffix(digits.size());
    return number;
}

bool take_ending(std::string_view& name, std::string_view ending)
{
    if (!name.ends_with(ending))
        return false;
    name.remove_suffix(ending.size());
    return true;
}

// Returns the process id in a name made by unfinished_path(), or in the name of a journal of a
// database with such a name.
std::optional<pid_t> process_in(std::string_view name)
{
    for (auto const* const journal : { "-wal", "-shm", "-journal" })
        if (take_ending(name, journal))
            break;
    if (!take_ending(name, ".part"))
        return std::nullopt;
    take_ending(name, ".part"); // Accepts "….part.part": a temporary copy of a database.
    if (!take_number(name) || !take_ending(name, "-"))
        return std::nullopt;
    auto const process = take_number(name);
    if (!process || *process <= 0 || !take_ending(name, "."))
        return std::nullopt;
    return static_cast<pid_t>(*process);
}

bool is_abandoned(fs::directory_entry const& entry)
{
    auto const process = process_in(entry.path().filename().native());
    if (!process || ::kill(*process, 0) == 0 || errno != ESRCH)
        return false;
    std::error_code error;
    auto const changed = entry.last_write_time(error);
    return !error && changed < fs::file_time_type::clock::now() - std::chrono::days(1);
}

void remove_abandoned_files(fs::path const& folder)
{
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (is_abandoned(*entry)) {
            std::error_code ignored;
            fs::remove(entry->path(), ignored);
        }
}

void remove_abandoned_files_once(fs::path const& folder)
{
    static std::mutex mutex;
    static std::set<fs::path> done;
    std::lock_guard const lock(mutex);
    if (done.insert(folder).second)
        remove_abandoned_files(folder);
}

} // namespace

fs::path unfinished_path(fs::path const& target)
{
    static std::atomic<unsigned> count = 0;
    remove_abandoned_files_once(target.has_parent_path() ? target.parent_path() : ".");
    return fmt::format("{}.{}-{}.part", target.string(), ::getpid(), count++);
}

struct UnfinishedFile::Place {
    enum class Use { Free, Taken, Named };
    std::atomic<Use> use = Use::Free;
    std::array<char, 1024> path {};
};

static constexpr std::size_t kPlaces = 32;

UnfinishedFile::Place* UnfinishedFile::places()
{
    static_assert(std::atomic<Place::Use>::is_always_lock_free,
                  "a signal's handler may use nothing else");
    static std::array<Place, kPlaces> all {};
    return all.data();
}

UnfinishedFile::UnfinishedFile(fs::path const& written)
{
    auto const& name = written.native();
    if (name.size() >= Place().path.size())
        return;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        auto& place = places()[i];
        auto free = Place::Use::Free;
        if (!place.use.compare_exchange_strong(free, Place::Use::Taken))
            continue;
        std::copy_n(name.c_str(), name.size() + 1, place.path.begin());
        place.use = Place::Use::Named;
        mine_ = &place;
        return;
    }
}

UnfinishedFile::~UnfinishedFile()
{
    if (mine_ != nullptr)
        mine_->use = Place::Use::Free;
}

// Calls only functions that are allowed in a signal handler.
void UnfinishedFile::remove_all_and_die(int signal)
{
    for (std::size_t i = 0; i < kPlaces; ++i)
        if (auto const& place = places()[i]; place.use == Place::Use::Named)
            ::unlink(place.path.data());
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void remove_unfinished_file_on_signals()
{
    static_cast<void>(UnfinishedFile::places()); // Creates the table before a handler needs it.
    for (int const signal : { SIGINT, SIGTERM, SIGHUP })
        if (std::signal(signal, UnfinishedFile::remove_all_and_die) == SIG_IGN)
            // The signal was ignored before the program started, for example by nohup: keep
            // ignoring it.
            std::signal(signal, SIG_IGN);
}

} // namespace tractus
