#include "app/window/mouse_queue.h"

namespace tractus::window {

MouseQueue::Part MouseQueue::take_part()
{
    Part part;
    auto next = waiting_.begin();
    for (; next != waiting_.end(); ++next) {
        bool const changes = next->is_down != is_down_;
        if (changes && part.change)
            break;
        if (changes)
            part.change = *next;
        is_down_ = next->is_down;
        part.path.push_back(*next);
    }
    waiting_.erase(waiting_.begin(), next);
    return part;
}

} // namespace tractus::window
