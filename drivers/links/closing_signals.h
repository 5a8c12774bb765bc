#pragma once

namespace tractus::drivers {

// While one of these is there, a signal that asks the program to end (Ctrl-C, SIGTERM, SIGHUP) does
// not end it, but is remembered, so that somebody who draws can finish and keep what is under way.
// A second Ctrl-C ends the program at once, as without this: a person may not want to wait. Signals
// that were ignored stay so. One at a time; for the main thread.
class ClosingSignals {
public:
    ClosingSignals();
    ~ClosingSignals(); // Makes signals do what they did before.
    ClosingSignals(ClosingSignals const&) = delete;
    ClosingSignals& operator=(ClosingSignals const&) = delete;

    // Whether one of them has come, in the life of this object or of an earlier one.
    static bool have_come();
};

} // namespace tractus::drivers
