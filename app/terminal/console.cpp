#include "app/terminal/console.h"

#include "engine/base/printable.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <string>
#include <unistd.h>

namespace tractus::terminal {

void prepare_console()
{
    for (int const stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
        if (::fcntl(stream, F_GETFD) == -1)
            // open() returns the lowest free descriptor, which is that of the closed stream. It is
            // opened for the opposite access, so that using the stream still fails.
            (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    std::signal(SIGXFSZ, SIG_IGN);
}

// True if the text contains only printable ASCII characters, tabs and line breaks.
static bool is_plain(std::string_view text)
{
    return std::all_of(text.begin(), text.end(), [](char character) {
        auto const code = static_cast<unsigned char>(character);
        return (code >= 0x20 && code < 0x7f) || code == '\n' || code == '\t';
    });
}

Result<void> print_out(std::string_view text)
{
    std::string escaped;
    if (!is_plain(text))
        text = escaped = printable(text, "\n\t");
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
        return {};
    return fail(Fault::User,
                fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

void print_error(std::string_view text)
{
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
    (void)std::fflush(stderr);
}

} // namespace tractus::terminal
