#include "engine/base/urgency.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace tractus {

static thread_local Urgency present = Urgency::Now;

// Lowers the calling thread alone. A system that refuses leaves it as it is.
static void lower_to(Urgency urgency)
{
    constexpr int kNice = 10;
    static thread_local Urgency lowest = Urgency::Now;
    if (urgency <= lowest)
        return;
    // A thread of this policy that wakes does not take the processor from the one that runs.
    sched_param const none {};
    ::sched_setscheduler(0, SCHED_BATCH, &none);
    if (urgency == Urgency::Later)
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
    lowest = urgency;
}

void set_urgency(Urgency urgency)
{
    present = urgency;
    lower_to(urgency);
}

Urgency present_urgency()
{
    return present;
}

PieceOfWork::PieceOfWork(Urgency urgency)
    : before_(std::exchange(present, urgency))
{
    lower_to(urgency);
}

PieceOfWork::~PieceOfWork()
{
    present = before_;
}

} // namespace tractus
