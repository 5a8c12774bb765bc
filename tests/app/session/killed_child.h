#pragma once

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace tractus::session {

// Reports a number to the parent process, which uses only the last one.
using Say = std::function<void(int)>;

// Runs `work` in a child process and kills it after `life`. Returns the last number that the child
// has reported, or -1 if there is none. The parent must not have threads, since they would be
// missing in the child; so it derives no plants.
inline int last_said(std::function<void(Say const&)> const& work, std::chrono::microseconds life)
{
    int ends[2];
    if (::pipe(ends) != 0)
        return -2;
    auto const child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        work([&](int number) { (void)!::write(ends[1], &number, sizeof number); });
        ::_exit(0);
    }
    ::close(ends[1]);
    using Clock = std::chrono::steady_clock;
    auto const end = Clock::now() + life;
    while (Clock::now() < end && ::waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(
            std::min<Clock::duration>(std::chrono::microseconds(200), end - Clock::now()));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    int last = -1;
    while (::read(ends[0], &last, sizeof last) == sizeof last) { }
    ::close(ends[0]);
    return last;
}

// A life that is never over. If a test hangs, the test runner ends it.
constexpr std::chrono::hours kForever { 24 };

} // namespace tractus::session
