#pragma once

#include <memory>

namespace tractus {

// While it lives, the thread that made it and the workers that help it in parallel loops are at
// work in the background: below the threads that a person waits for, such as the one that shows the
// pen's ink. What a thread was made for cannot be taken back on Linux, so both stay there
// afterwards.
class BackgroundThread {
public:
    BackgroundThread();
    ~BackgroundThread();
    BackgroundThread(BackgroundThread const&) = delete;
    BackgroundThread& operator=(BackgroundThread const&) = delete;

private:
    struct Workers;
    std::unique_ptr<Workers> workers_;
};

} // namespace tractus
