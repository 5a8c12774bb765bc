#pragma once

namespace tractus {

// How soon the result of a thread's work is needed.
enum class Urgency {
    Now,  // Due in this frame: threads that read devices or show the pen's ink.
    Soon, // Needed a few frames later: does not preempt threads of urgency Now.
    // Work for idle times, such as growing plants: also yields the processor to all other threads.
    Later,
};

// Sets the urgency of the calling thread, and of the threads that help it in parallel loops
// (parallel.h). The priority of a thread can only be lowered, never raised again: Linux does not
// permit it.
void set_urgency(Urgency urgency);

// Returns the urgency of the work that the calling thread is doing.
Urgency present_urgency();

// Gives the calling thread's work this urgency while the object exists; the destructor restores the
// urgency that the work had before. The thread's priority, once lowered, stays low.
class UrgencyScope {
public:
    explicit UrgencyScope(Urgency urgency);
    ~UrgencyScope();
    UrgencyScope(UrgencyScope const&) = delete;
    UrgencyScope& operator=(UrgencyScope const&) = delete;

private:
    Urgency before_;
};

} // namespace tractus
