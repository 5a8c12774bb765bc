#include "app/terminal/terminal_keys.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace tractus::terminal {

struct TerminalKeys::Before {
    termios settings {};
};

TerminalKeys::TerminalKeys()
{
    Before before;
    if (::tcgetattr(STDIN_FILENO, &before.settings) != 0)
        return;
    before_ = std::make_unique<Before>(before);
    auto settings = before.settings;
    settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    (void)::tcsetattr(STDIN_FILENO, TCSANOW, &settings);
}

TerminalKeys::~TerminalKeys()
{
    if (before_)
        (void)::tcsetattr(STDIN_FILENO, TCSANOW, &before_->settings);
}

std::optional<char> TerminalKeys::read()
{
    constexpr char kEndOfInput = '\4';
    pollfd input { .fd = STDIN_FILENO, .events = POLLIN, .revents = 0 };
    if (::poll(&input, 1, 0) <= 0)
        return std::nullopt;
    char key = 0;
    return ::read(STDIN_FILENO, &key, 1) == 1 ? key : kEndOfInput;
}

bool TerminalKeys::is_terminal() const
{
    return before_ != nullptr;
}

} // namespace tractus::terminal
