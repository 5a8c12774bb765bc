#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace tractus::stream {

// A local stream socket (AF_UNIX) from which up to kMaxReaders programs read the same lines. It
// never blocks: unsent data is queued for each reader, and readers that disconnect are removed. It
// has no thread, so serve() has to be called regularly. Not thread-safe.
class LineServer {
public:
    static constexpr std::size_t kMaxReaders = 64;
    // Queue length above which a reader gets no more lines of Importance::LeaveOut.
    static constexpr std::size_t kMaxWaiting = std::size_t { 1 } << 20;
    // Queue length above which a reader is disconnected.
    static constexpr std::size_t kMaxKept = std::size_t { 64 } << 20;
    // A reader that fetches nothing for this long is no longer waited for until it reads again.
    static constexpr Duration kPatience = std::chrono::seconds(5);

    // Listens on a socket file that only its owner may use; a stale socket of a terminated program
    // is replaced. Each reader first receives `greeting`. Fails with a user error if another
    // program listens there, if the file is something else, or if the path is too long for a socket
    // (107 bytes).
    static Result<LineServer> listen(std::filesystem::path const& path, std::string greeting);

    LineServer(LineServer&&) noexcept;
    LineServer& operator=(LineServer&&) noexcept;
    ~LineServer(); // Closes the socket and removes its file.

    // The treatment of a line if a reader is too slow.
    enum class Importance {
        // The line is dropped; a line with the number of dropped lines precedes the next kept one.
        LeaveOut,
        Keep, // The line is queued.
    };

    // Sends a line to all current readers.
    void publish(std::string_view line, Importance importance);

    // Accepts new readers, sends queued data, and removes readers that have disconnected. `now` may
    // come from any clock but must not decrease.
    void serve(Timestamp now);

    std::size_t reader_count() const;

    // Length of the longest queue in bytes, ignoring readers that have fetched nothing for
    // kPatience.
    std::size_t waiting_bytes() const;

private:
    struct Parts;
    explicit LineServer(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

} // namespace tractus::stream
