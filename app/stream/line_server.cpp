#include "app/stream/line_server.h"

#include "app/stream/stream_lines.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/core.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tractus::stream {

// Owner of a file descriptor, which the destructor closes.
class SocketDescriptor {
public:
    explicit SocketDescriptor(int number)
        : number_(number)
    {
    }
    SocketDescriptor(SocketDescriptor&& other) noexcept
        : number_(std::exchange(other.number_, -1))
    {
    }
    SocketDescriptor& operator=(SocketDescriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~SocketDescriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }

    int number() const { return number_; }

private:
    int number_;
};

// A connected reader, with the data that it has not received yet.
class LineReader {
public:
    LineReader(SocketDescriptor socket, std::string greeting, Timestamp now)
        : socket_(std::move(socket))
        , waiting_(std::move(greeting))
        , last_taken_(now)
    {
    }

    void add(std::string_view line, LineServer::Importance importance)
    {
        if (importance == LineServer::Importance::LeaveOut
            && waiting_bytes() > LineServer::kMaxWaiting) {
            ++left_out_;
            return;
        }
        if (auto const count = std::exchange(left_out_, 0); count > 0)
            waiting_ += lost_line(count);
        waiting_ += line;
        if (waiting_bytes() > LineServer::kMaxKept)
            is_gone_ = true;
    }

    // Sends as much of the waiting data as possible without blocking.
    void send(Timestamp now)
    {
        bool has_taken = sent_ == waiting_.size();
        while (sent_ < waiting_.size() && !is_gone_) {
            auto const count = ::send(socket_.number(), waiting_.data() + sent_,
                                      waiting_.size() - sent_, MSG_DONTWAIT | MSG_NOSIGNAL);
            if (count < 0 && errno == EINTR)
                continue;
            if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
                break;
            if (count <= 0)
                is_gone_ = true;
            else
                sent_ += static_cast<std::size_t>(count);
            has_taken |= count > 0;
        }
        forget_sent();
        if (has_taken)
            last_taken_ = now;
        is_stalled_ = now - last_taken_ >= LineServer::kPatience;
    }

    // True if data is waiting but the reader has fetched none for kPatience.
    bool is_stalled() const { return is_stalled_; }

    // True if the reader has disconnected. A reader whose connection is half closed, as by shells,
    // can still read and does not count.
    bool is_gone() const
    {
        pollfd state { .fd = socket_.number(), .events = 0, .revents = 0 };
        return is_gone_ || (::poll(&state, 1, 0) > 0 && (state.revents & (POLLHUP | POLLERR)) != 0);
    }

    std::size_t waiting_bytes() const { return waiting_.size() - sent_; }

private:
    // Removes sent data from the queue, but only once it is at least half of the queue, as the rest
    // must be moved.
    void forget_sent()
    {
        if (sent_ < waiting_.size() / 2)
            return;
        waiting_.erase(0, sent_);
        sent_ = 0;
    }

    SocketDescriptor socket_;
    std::string waiting_;
    std::size_t sent_ = 0; // Number of bytes at the beginning of waiting_ that have been sent.
    std::size_t left_out_ = 0;
    Timestamp last_taken_; // Time at which the reader last fetched data, or had no data waiting.
    bool is_stalled_ = false;
    bool is_gone_ = false;
};

namespace {

SocketDescriptor new_socket()
{
    return SocketDescriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

Result<sockaddr_un> socket_address(std::filesystem::path const& path)
{
    sockaddr_un address {};
    address.sun_family = AF_UNIX;
    auto const& name = path.native();
    if (name.empty() || name.size() >= sizeof address.sun_path)
        return fail(Fault::User,
                    fmt::format("{}: a socket's name has 1 to {} bytes, and this one {}: choose "
                                "another place",
                                name, sizeof address.sun_path - 1, name.size()));
    std::memcpy(address.sun_path, name.data(), name.size());
    return address;
}

// Removes the socket file that a terminated program has left behind.
Result<void> make_room(std::filesystem::path const& path, sockaddr_un const& address)
{
    struct stat there { };
    if (::lstat(path.c_str(), &there) != 0)
        return {};
    if (!S_ISSOCK(there.st_mode))
        return fail(Fault::User,
                    fmt::format("{} is there already, and is no socket: choose another name",
                                path.string()));
    auto const caller = new_socket();
    if (::connect(caller.number(), reinterpret_cast<sockaddr const*>(&address), sizeof address) == 0
        || errno == EAGAIN)
        return fail(
            Fault::User,
            fmt::format("another program streams at {}: choose another name", path.string()));
    ::unlink(path.c_str());
    return {};
}

} // namespace

struct LineServer::Parts {
    std::filesystem::path path;
    std::string greeting;
    SocketDescriptor socket;
    std::vector<LineReader> readers {};

    void let_in(Timestamp now)
    {
        while (readers.size() < kMaxReaders) {
            SocketDescriptor caller(
                ::accept4(socket.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
            if (caller.number() < 0)
                return;
            readers.emplace_back(std::move(caller), greeting, now);
        }
    }
};

Result<LineServer> LineServer::listen(std::filesystem::path const& path, std::string greeting)
{
    auto const address = TRY(socket_address(path));
    TRY(make_room(path, address));
    auto socket = new_socket();
    // The permissions are restricted before the socket gets its name, so that other users can never
    // connect.
    if (socket.number() < 0 || ::fchmod(socket.number(), S_IRUSR | S_IWUSR) != 0
        || ::bind(socket.number(), reinterpret_cast<sockaddr const*>(&address), sizeof address) != 0
        || ::listen(socket.number(), kMaxReaders) != 0)
        return fail(Fault::User,
                    fmt::format("cannot listen at {}: {}", path.string(), std::strerror(errno)));
    return LineServer(std::make_unique<Parts>(
        Parts { .path = path, .greeting = std::move(greeting), .socket = std::move(socket) }));
}

LineServer::LineServer(std::unique_ptr<Parts> parts)
    : parts_(std::move(parts))
{
}

LineServer::LineServer(LineServer&&) noexcept = default;
LineServer& LineServer::operator=(LineServer&&) noexcept = default;

LineServer::~LineServer()
{
    if (parts_)
        ::unlink(parts_->path.c_str());
}

void LineServer::publish(std::string_view line, Importance importance)
{
    for (auto& reader : parts_->readers)
        reader.add(line, importance);
}

void LineServer::serve(Timestamp now)
{
    parts_->let_in(now);
    for (auto& reader : parts_->readers)
        reader.send(now);
    std::erase_if(parts_->readers, [](LineReader const& reader) { return reader.is_gone(); });
}

std::size_t LineServer::reader_count() const
{
    return parts_->readers.size();
}

std::size_t LineServer::waiting_bytes() const
{
    std::size_t most = 0;
    for (auto const& reader : parts_->readers)
        if (!reader.is_stalled())
            most = std::max(most, reader.waiting_bytes());
    return most;
}

} // namespace tractus::stream
