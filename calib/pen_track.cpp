#include "calib/pen_track.h"

#include "calib/even_times.h"
#include "calib/lean_track.h"

namespace tractus::calib {

static constexpr Duration kAllOfIt = std::chrono::hours(24);
static constexpr Duration kLongestGap = std::chrono::milliseconds(50);
static constexpr Duration kStretch = std::chrono::milliseconds(500);

static Timestamp time_of(Timestamp arrival, Rig const& rig, EvenTimes& times)
{
    return rig.sample_times == SampleTimes::Evened ? times.add(arrival) : arrival;
}

std::vector<TouchPoint> touch_points(std::span<drivers::PenSample const> pens, Rig const& rig)
{
    auto level = rig;
    level.travel_shear = Vec2::Zero();
    auto const T_world_tablet = calib::T_world_tablet(level);
    std::vector<TouchPoint> points;
    EvenTimes times;
    LeanTrack leans(kAllOfIt);
    for (auto const& pen : pens)
        leans.add(pen);
    for (auto const& pen : pens) {
        auto const time = time_of(pen.time, rig, times);
        if (!pen.touching)
            continue;
        Vec2 const nib = nib_mm(pen, leans, rig);
        Vec3 const place_mm = T_world_tablet * Vec3(nib.x(), nib.y(), 0);
        points.push_back({ time - rig.tablet_latency, place_mm.head<2>() });
    }
    return points;
}

HeightTrack height_track(std::span<drivers::HeightSample const> heights, Rig const& rig)
{
    HeightTrack track(kAllOfIt);
    EvenTimes times;
    for (auto const& sample : heights) {
        auto const time = time_of(sample.time, rig, times);
        if (sample.full_scale == rig.full_scale_counts)
            if (auto const height = height_mm(rig.height_model, sample.counts))
                track.add(time - rig.height_latency, *height);
    }
    return track;
}

std::optional<double> height_between(HeightTrack const& track, Timestamp time)
{
    auto const estimate = track.at(time, kLongestGap);
    if (!estimate || estimate->kind != TipSample::HeightSource::Interpolated)
        return std::nullopt;
    return estimate->height_mm;
}

int stretch_of(Timestamp time)
{
    return static_cast<int>(time.time_since_epoch() / kStretch);
}

} // namespace tractus::calib
