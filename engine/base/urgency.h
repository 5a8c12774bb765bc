#pragma once

namespace tractus {

// How soon somebody needs what a thread does.
enum class Urgency {
    Now,   // In this frame: the threads that read devices and show the pen's ink.
    Soon,  // A few frames later: it does not interrupt who has woken it.
    Later, // When there is time: growing plants. It also leaves the processor to all others first.
};

// From here on the calling thread, and the threads that help it in parallel loops (parallel.h), are
// at work for something of this urgency. A thread that has once been less urgent stays so, since
// Linux lets nobody take it back.
void set_urgency(Urgency urgency);

// Of what the calling thread is doing.
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
