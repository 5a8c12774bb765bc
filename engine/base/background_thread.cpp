#include "engine/base/background_thread.h"

#include <sys/resource.h>
#include <tbb/task_scheduler_observer.h>
#include <unistd.h>

namespace tractus {

namespace {

// On Linux the calling thread's alone. A system that refuses leaves it as it is.
void lower_priority()
{
    constexpr int kNice = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

} // namespace

// Of loops that this thread begins.
struct BackgroundThread::Workers final : tbb::task_scheduler_observer {
    Workers() { observe(true); }
    ~Workers() override { observe(false); }

    void on_scheduler_entry(bool is_worker) override
    {
        if (is_worker)
            lower_priority();
    }
};

BackgroundThread::BackgroundThread()
    : workers_(std::make_unique<Workers>())
{
    lower_priority();
}

BackgroundThread::~BackgroundThread() = default;

} // namespace tractus
