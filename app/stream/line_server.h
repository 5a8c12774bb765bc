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
// never blocks: data that cannot be sent at once is queued for each reader, and readers that
// disconnect are removed. It has no thread, so serve() must be called regularly. Not thread-safe.
class LineServer {
public:
    static constexpr std::size_t kMaxReaders = 64;
    // Size of a reader's queue, in bytes, above which lines with Importance::LeaveOut are dropped
    // for it.
    static constexpr std::size_t kMaxWaiting = std::size_t { 1 } << 20;
    // Size of a reader's queue, in bytes, above which the reader is disconnected.
    static constexpr std::size_t kMaxKept = std::size_t { 64 } << 20;
    // A reader that fetches nothing for this long no longer counts in waiting_bytes(), until it
    // reads again.
    static constexpr Duration kPatience = std::chrono::seconds(5);

    // Listens on a socket file that only its owner may use. A socket that a terminated program has
    // left there is replaced. Each reader first receives `greeting`. Fails with a user error if
    // another program listens there, if the file is not a socket, or if the path is too long for a
    // socket (107 bytes).
    static Result<LineServer> listen(std::filesystem::path const& path, std::string greeting);

    LineServer(LineServer&&) noexcept;
    LineServer& operator=(LineServer&&) noexcept;
    ~LineServer(); // Closes the socket and removes its file.

    // What happens to a line for a reader that is too slow.
    enum class Importance {
        // The line is dropped. Before the reader's next line, it receives the number of dropped
        // lines.
        LeaveOut,
        Keep, // The line is queued until the reader fetches it.
    };

    // Adds a line to the queues of all current readers; serve() sends it.
    void publish(std::string_view line, Importance importance);

    // Accepts new readers, sends queued data, and removes readers that have disconnected. `now` is
    // the time of any clock, but must not decrease from call to call.
    void serve(Timestamp now);

    std::size_t reader_count() const;

    // Size of the longest queue in bytes. Readers that have fetched nothing for kPatience do not
    // count.
    std::size_t waiting_bytes() const;

private:
    struct Parts;
    explicit LineServer(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

} // namespace tractus::stream
