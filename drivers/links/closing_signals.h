#pragma once

namespace tractus::drivers {

// While an object exists, a termination signal (Ctrl-C, SIGTERM, SIGHUP) is recorded instead of
// ending the program, so that work in progress can be finished and saved. A second Ctrl-C ends the
// program at once. Ignored signals stay ignored. One object at a time, main thread only.
class ClosingSignals {
public:
    ClosingSignals();
    ~ClosingSignals(); // Restores the previous signal handlers.
    ClosingSignals(ClosingSignals const&) = delete;
    ClosingSignals& operator=(ClosingSignals const&) = delete;

    // True if a signal has arrived during the life of this or an earlier object.
    static bool has_signal_arrived();
};

} // namespace tractus::drivers
