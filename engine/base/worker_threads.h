#pragma once

namespace tractus {

// Ends the threads that have helped with loops (parallel.h), and returns when they are gone: at the
// end of a program, where threads that go by themselves would run beside its last clearing up.
// Later loops begin new ones. Called while no loop runs.
void end_worker_threads();

} // namespace tractus
