#include "engine/base/urgency.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace tractus {

static thread_local Urgency present = Urgency::Now;

// Lowers the priority of the calling thread only. If the system refuses, the priority stays.
static void lower_to(Urgency urgency)
{
    constexpr int kNice = 10;
    static thread_local Urgency lowest = Urgency::Now;
    if (urgency <= lowest)
        return;
    // With SCHED_BATCH a thread that wakes up does not preempt the running one.
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

UrgencyScope::UrgencyScope(Urgency urgency)
    : before_(std::exchange(present, urgency))
{
    lower_to(urgency);
}

UrgencyScope::~UrgencyScope()
{
    present = before_;
}

} // namespace tractus
