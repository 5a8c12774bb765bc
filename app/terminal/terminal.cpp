#include "app/terminal/terminal.h"

#include <cstdio>
#include <cstdlib>
#include <fmt/core.h>
#include <ncurses.h>
#include <unistd.h>

namespace tractus::terminal {

// ncurses's state for the terminal.
struct Terminal::Screen {
    explicit Screen(SCREEN* opened)
        : curses(opened)
    {
    }
    ~Screen()
    {
        ::endwin();
        ::delscreen(curses);
    }
    Screen(Screen const&) = delete;
    Screen& operator=(Screen const&) = delete;

    SCREEN* curses;
};

bool is_terminal()
{
    return ::isatty(STDOUT_FILENO) != 0 && ::isatty(STDIN_FILENO) != 0;
}

Result<Terminal> Terminal::open()
{
    SCREEN* const opened = ::newterm(nullptr, stdout, stdin);
    if (opened == nullptr) {
        char const* const kind = std::getenv("TERM");
        return fail(Fault::User,
                    fmt::format("the terminal's kind '{}' is not known: set TERM, or pipe the "
                                "output through cat",
                                kind ? kind : ""));
    }
    ::set_term(opened);
    ::cbreak();
    ::noecho();
    ::curs_set(0);
    ::nodelay(stdscr, TRUE);
    return Terminal(std::make_unique<Screen>(opened));
}

Terminal::Terminal(std::unique_ptr<Screen> screen)
    : screen_(std::move(screen))
{
}

Terminal::Terminal(Terminal&&) noexcept = default;
Terminal& Terminal::operator=(Terminal&&) noexcept = default;
Terminal::~Terminal() = default;

std::size_t Terminal::width() const
{
    return static_cast<std::size_t>(getmaxx(stdscr));
}

void Terminal::show(std::vector<std::string> const& lines, std::string const& status)
{
    int const height = getmaxy(stdscr);
    int const width = getmaxx(stdscr);
    ::erase();
    for (int row = 0; row < height - 1 && row < static_cast<int>(lines.size()); ++row)
        mvaddnstr(row, 0, lines[static_cast<std::size_t>(row)].c_str(), width);
    ::attron(A_REVERSE);
    mvaddnstr(height - 1, 0, fmt::format("{:<{}}", status, width - 1).c_str(), width - 1);
    ::attroff(A_REVERSE);
    ::refresh();
}

std::optional<char> Terminal::key()
{
    int const key = ::getch();
    return key > 0 && key < 128 ? std::optional(static_cast<char>(key)) : std::nullopt;
}

} // namespace tractus::terminal
