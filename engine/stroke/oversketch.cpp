#include "engine/stroke/oversketch.h"

#include "engine/stroke/polyline.h"

#include <algorithm>
#include <fmt/format.h>
#include <span>

namespace tractus {

namespace {

struct NearestTip {
    std::size_t index = 0;
    double distance_mm = 0;
};

NearestTip nearest_tip(Stroke const& stroke, Vec3 const& place_mm)
{
    NearestTip nearest { 0, (stroke.tips[0].position_mm - place_mm).norm() };
    for (std::size_t i = 1; i < stroke.tips.size(); ++i)
        if (double const distance = (stroke.tips[i].position_mm - place_mm).norm();
            distance < nearest.distance_mm)
            nearest = { i, distance };
    return nearest;
}

// Moves the first and the last tip of `over` by the given vectors, and the tips between them by
// linearly interpolated vectors.
void shift(Stroke& over, Vec3 const& first_mm, Vec3 const& last_mm)
{
    auto& tips = over.tips.own();
    auto const count = static_cast<double>(tips.size() - 1);
    for (std::size_t i = 0; i < tips.size(); ++i) {
        double const share = static_cast<double>(i) / count;
        tips[i].position_mm += (1 - share) * first_mm + share * last_mm;
    }
}

// Appends tips, shifted in time to begin 1 ms after the end of the stroke. The time intervals
// between these tips are kept.
void append(Stroke& stroke, std::span<TipSample const> tips)
{
    if (tips.empty())
        return;
    Duration delay {};
    if (!stroke.tips.empty())
        delay = stroke.tips.back().time + std::chrono::milliseconds(1) - tips.front().time;
    for (auto tip : tips) {
        tip.time += delay;
        stroke.tips.push_back(tip);
    }
}

} // namespace

Result<Stroke> oversketch(Stroke const& drawn, Stroke over, double finger_mm)
{
    TRY(stroke_points(drawn));
    TRY(stroke_points(over));
    auto first = nearest_tip(drawn, over.tips.front().position_mm);
    auto last = nearest_tip(drawn, over.tips.back().position_mm);
    bool const first_near = first.distance_mm <= finger_mm;
    bool const last_near = last.distance_mm <= finger_mm;
    if (!first_near && !last_near)
        return fail(Fault::User,
                    fmt::format("the new line begins and ends {:.0f} mm or more beside the stroke "
                                "that it should redraw: begin or end it on the stroke",
                                std::min(first.distance_mm, last.distance_mm)));
    // `over` was drawn against the direction of `drawn`.
    if (first_near && last_near && first.index > last.index) {
        auto const begin = over.tips.front().time;
        auto const end = over.tips.back().time;
        auto& tips = over.tips.own();
        std::reverse(tips.begin(), tips.end());
        for (auto& tip : tips)
            tip.time = begin + (end - tip.time);
        std::swap(first, last);
    }
    auto const from = first_near ? first.index : 0;
    auto const to = last_near ? last.index : drawn.tips.size() - 1;
    auto const gap = [&](std::size_t index, TipSample const& tip) {
        return Vec3(drawn.tips[index].position_mm - tip.position_mm);
    };
    shift(over, first_near ? gap(from, over.tips.front()) : Vec3::Zero(),
          last_near ? gap(to, over.tips.back()) : Vec3::Zero());

    std::span<TipSample const> const tips(drawn.tips);
    Stroke redrawn;
    if (first_near)
        append(redrawn, tips.first(from));
    append(redrawn, over.tips);
    if (last_near)
        append(redrawn, tips.subspan(to + 1));
    return redrawn;
}

} // namespace tractus
