#include "app/view/steady_frame.h"

#include <algorithm>

namespace tractus::view {

void SteadyFrame::add(Vec3 const& point_mm)
{
    if (!first_mm_) {
        first_mm_ = point_mm;
        lowest_mm_ = point_mm.z();
        reach_mm_.fill(kFirstReach_mm * unit_);
        reach_mm_.back() = kFirstHeight_mm * unit_;
    }
    Vec3 const way_mm = point_mm - *first_mm_;
    std::array const ways_mm { -way_mm.x(), way_mm.x(), -way_mm.y(), way_mm.y(), way_mm.z() };
    for (std::size_t i = 0; i < ways_mm.size(); ++i)
        while (ways_mm[i] > reach_mm_[i])
            reach_mm_[i] *= kStep;
    lowest_mm_ = std::min(lowest_mm_, point_mm.z());
}

Bounds SteadyFrame::box_mm() const
{
    Bounds box;
    if (!first_mm_)
        return box;
    box.add(Vec3(first_mm_->x() - reach_mm_[0], first_mm_->y() - reach_mm_[2], lowest_mm_));
    box.add(*first_mm_ + Vec3(reach_mm_[1], reach_mm_[3], reach_mm_[4]));
    return box;
}

} // namespace tractus::view
