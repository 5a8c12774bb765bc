#include "app/terminal/progress.h"

#include "app/terminal/console.h"

#include <fmt/core.h>
#include <unistd.h>

namespace tractus::terminal {

static constexpr auto kQuiet = std::chrono::seconds(1);
static constexpr auto kBetweenLines = std::chrono::milliseconds(1000);
static constexpr auto kBetweenRewrites = std::chrono::milliseconds(100);

Progress::Progress()
    : on_terminal_(::isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
    finish();
}

void Progress::begin(std::string stage, std::size_t total)
{
    finish();
    stage_ = std::move(stage);
    done_ = 0;
    total_ = total;
    begun_ = Clock::now();
    shown_ = {};
}

void Progress::step()
{
    ++done_;
    show();
}

void Progress::finish()
{
    if (stage_.empty())
        return;
    if (line_open_)
        print_error("\r\033[K");
    line_open_ = false;
    times_.push_back({ stage_, std::chrono::duration<double>(Clock::now() - begun_).count() });
    stage_.clear();
}

void Progress::show()
{
    auto const now = Clock::now();
    auto const pause = on_terminal_ ? kBetweenRewrites : kBetweenLines;
    if (now - begun_ < kQuiet || now - shown_ < pause)
        return;
    shown_ = now;
    auto const count = total_ ? fmt::format(" {} of {}", done_, total_) : fmt::format(" {}", done_);
    if (on_terminal_)
        print_error(fmt::format("\r\033[K{}{}", stage_, count));
    else
        print_error(fmt::format("{}{}\n", stage_, count));
    line_open_ = on_terminal_;
}

} // namespace tractus::terminal
