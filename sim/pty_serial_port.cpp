#include "sim/pty_serial_port.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <system_error>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace tractus::sim {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kTerminals = "/dev/pts/";

tl::unexpected<Error> no_terminal()
{
    return fail(Fault::User,
                fmt::format("cannot make a pseudo-terminal: {}: is devpts mounted at /dev/pts?",
                            std::strerror(errno)));
}

// Opens the node once and closes it, because only from then on does the kernel report whether
// anybody has it open. Raw mode keeps the kernel from echoing what is sent.
Result<void> make_raw(std::string const& node)
{
    FileDescriptor const file(::open(node.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios state {};
    if (!file || ::tcgetattr(file.number(), &state) != 0)
        return no_terminal();
    ::cfmakeraw(&state);
    if (::tcsetattr(file.number(), TCSANOW, &state) != 0)
        return no_terminal();
    return {};
}

bool is_link_to_terminal(fs::path const& link)
{
    std::error_code error;
    auto const target = fs::read_symlink(link, error);
    return !error && target.string().starts_with(kTerminals);
}

// Replaces the link atomically, so that it is never missing.
Result<void> make_link(std::string const& node, fs::path const& link)
{
    std::error_code error;
    if (fs::exists(fs::symlink_status(link, error)) && !is_link_to_terminal(link))
        return fail(Fault::User,
                    fmt::format("{} exists and is no link to a simulated serial port: choose "
                                "another name for the link",
                                link.string()));
    auto const fresh = fs::path(fmt::format("{}.{}", link.string(), ::getpid()));
    fs::create_symlink(node, fresh, error);
    if (!error)
        fs::rename(fresh, link, error);
    if (error)
        return fail(Fault::User,
                    fmt::format("cannot make the link {}: {}", link.string(), error.message()));
    return {};
}

} // namespace

Result<std::unique_ptr<PtySerialPort>> PtySerialPort::create(fs::path link)
{
    FileDescriptor file(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!file || ::grantpt(file.number()) != 0 || ::unlockpt(file.number()) != 0)
        return no_terminal();
    std::array<char, 64> name {};
    if (::ptsname_r(file.number(), name.data(), name.size()) != 0)
        return no_terminal();
    std::unique_ptr<PtySerialPort> port(new PtySerialPort(std::move(file), name.data()));
    TRY(make_raw(port->node_));
    if (!link.empty())
        TRY(make_link(port->node_, link));
    port->link_ = std::move(link);
    return port;
}

PtySerialPort::~PtySerialPort()
{
    std::error_code error;
    if (!link_.empty() && fs::read_symlink(link_, error) == node_)
        fs::remove(link_, error);
}

Result<void> PtySerialPort::serve()
{
    pollfd end { .fd = file_.number(), .events = POLLIN, .revents = 0 };
    is_read_ = ::poll(&end, 1, 0) >= 0 && (end.revents & POLLHUP) == 0;
    was_read_ |= is_read_;
    std::array<char, 256> ignored {};
    while (is_read_ && ::read(file_.number(), ignored.data(), ignored.size()) > 0) { }
    return {};
}

Result<void> PtySerialPort::send(std::span<std::byte const> bytes)
{
    TRY(serve());
    auto const sent = is_read_ ? ::write(file_.number(), bytes.data(), bytes.size()) : 0;
    if (sent != std::ssize(bytes) && was_read_)
        ++lost_;
    return {};
}

} // namespace tractus::sim
