#include "drivers/links/closing_signals.h"

#include <array>
#include <atomic>
#include <csignal>

namespace tractus::drivers {

namespace {

constexpr std::array kSignals { SIGINT, SIGTERM, SIGHUP };

std::atomic<bool> signal_has_come = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal's handler may use nothing else");
std::array<struct sigaction, kSignals.size()> earlier_actions {};

// Signal handler; only async-signal-safe calls.
void remember(int signal)
{
    bool const is_second = signal_has_come.exchange(true);
    if (!is_second || signal != SIGINT)
        return;
    ::sigaction(SIGINT, &earlier_actions[0], nullptr);
    ::raise(SIGINT); // Delivered when this handler returns.
}

} // namespace

ClosingSignals::ClosingSignals()
{
    struct sigaction action { };
    action.sa_handler = remember;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &earlier_actions[i]);
        if (earlier_actions[i].sa_handler != SIG_IGN)
            ::sigaction(kSignals[i], &action, nullptr);
    }
}

ClosingSignals::~ClosingSignals()
{
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        ::sigaction(kSignals[i], &earlier_actions[i], nullptr);
}

bool ClosingSignals::has_signal_arrived()
{
    return signal_has_come;
}

} // namespace tractus::drivers
