#pragma once

namespace tractus {

// Ends the helper threads of parallel loops (parallel.h) and returns when they have exited. Call it
// at the end of a program, so that these threads do not run beside the destruction of static
// objects. Later loops start new threads. Must not be called while a loop runs.
void end_worker_threads();

} // namespace tractus
