#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace tractus::stream {

// A local socket (AF_UNIX, a stream) from which any number of programs read the same lines, up to
// kMostReaders at a time. It never waits for them: what a reader does not take at once waits for
// it, and a reader that has gone is forgotten. It has no thread: serve() has to be called now and
// then. Not thread-safe.
class LineServer {
public:
    static constexpr std::size_t kMostReaders = 64;
    // While so much waits for a reader, it gets no more lines that may be left out…
    static constexpr std::size_t kMostWaiting = std::size_t { 1 } << 20;
    // …and when so much does, it is cut off.
    static constexpr std::size_t kMostKept = std::size_t { 64 } << 20;
    // A reader that takes nothing for so long is not waited for any more, until it reads again.
    static constexpr Duration kPatience = std::chrono::seconds(5);

    // Listens at a file's name, which only its owner may use; a socket that an ended program has
    // left there makes room. Each reader begins with `greeting`. Fails, as the user's fault, if
    // another program listens there, if something else is there, or if the name is too long for a
    // socket (107 bytes).
    static Result<LineServer> listen(std::filesystem::path const& path, std::string greeting);

    LineServer(LineServer&&) noexcept;
    LineServer& operator=(LineServer&&) noexcept;
    ~LineServer(); // Takes the socket's name away.

    // Fate of a line that a reader is too slow for.
    enum class Importance {
        LeaveOut, // It is left out; how many were, a line says before the next that is not.
        Keep,     // It waits.
    };

    // Gives a line to all who read now.
    void publish(std::string_view line, Importance importance);

    // Lets readers in, gives them what they take now, and forgets those that have gone. `now` is
    // read from one clock, any, and never decreases.
    void serve(Timestamp now);

    std::size_t reader_count() const;

    // Bytes that wait for the reader for whom the most do, without those who have taken nothing
    // for kPatience.
    std::size_t waiting_bytes() const;

private:
    struct Parts;
    explicit LineServer(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

} // namespace tractus::stream
