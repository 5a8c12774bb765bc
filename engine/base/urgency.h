#pragma once

namespace tractus {

// How soon somebody needs what a thread does.
enum class Urgency {
    Now,   // Due in this frame: the threads that read devices and show the pen's ink.
    Soon,  // A few frames later: it does not interrupt who has woken it.
    Later, // When there is time: growing plants. It also leaves the processor to all others first.
};

// Declares how urgent the work of the calling thread, and of the threads that help it in parallel
// loops (parallel.h), is from here on. A thread that has once been less urgent stays so, since
// Linux lets nobody take it back.
void set_urgency(Urgency urgency);

// The urgency of the calling thread's present work.
Urgency present_urgency();

// While it lives the calling thread does a piece of work of this urgency; afterwards it goes on
// with what it did before.
class PieceOfWork {
public:
    explicit PieceOfWork(Urgency urgency);
    ~PieceOfWork();
    PieceOfWork(PieceOfWork const&) = delete;
    PieceOfWork& operator=(PieceOfWork const&) = delete;

private:
    Urgency before_;
};

} // namespace tractus
