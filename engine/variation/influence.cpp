#include "engine/variation/influence.h"

#include "engine/base/parallel.h"
#include "engine/variation/subtree.h"

#include <fmt/format.h>

namespace tractus::variation {

namespace {

// One motion indicator, in millimetres of the plant instead of the displayed plant.
class LocalInfluence {
public:
    LocalInfluence(MotionIndicator indicator, ShownPlant const& shown)
        : indicator_(std::move(indicator))
        , push_((indicator_.end_mm - indicator_.start_mm) / shown.height_mm)
    {
        indicator_.start_mm /= shown.scale;
        indicator_.end_mm /= shown.scale;
        if (indicator_.reach_mm)
            *indicator_.reach_mm /= shown.scale;
    }

    Vec3 at(Vec3 const& place_mm) const
    {
        double const share = falloff(indicator_, distance_mm(indicator_, place_mm));
        if (indicator_.kind == MotionIndicator::Kind::Push)
            return share * push_;
        Vec3 const to_lamp = indicator_.end_mm - place_mm;
        double const distance = to_lamp.norm();
        return distance > 0 ? Vec3(share * push_.norm() / distance * to_lamp) : Vec3::Zero();
    }

private:
    MotionIndicator indicator_;
    Vec3 push_;
};

void add_local(Plant const& plant, std::span<Vec3 const> nodes_mm, LocalInfluence const& influence,
               std::span<AxisRemainder const> where, std::vector<Vec3>& local)
{
    constexpr std::size_t kAxesPerPiece = 256;
    parallel_for(where.size(), kAxesPerPiece, [&](std::size_t begin, std::size_t end) {
        for (auto const& [id, first] : where.subspan(begin, end - begin)) {
            auto const& axis = plant.axes[id];
            for (auto i = first - axis.first_segment; i < axis.segment_count; ++i) {
                auto const node = axis.first_node + i;
                local[axis.first_segment + i]
                    += influence.at((nodes_mm[node] + nodes_mm[node + 1]) / 2);
            }
        }
    });
}

// Returns the parts of axes on which an indicator acts, each axis at most once.
std::vector<AxisRemainder> places_of(Plant const& plant, MotionIndicator const& indicator)
{
    std::vector<AxisRemainder> places;
    if (indicator.below.empty()) {
        for (AxisId id = 0; id < plant.axes.size(); ++id)
            places.push_back({ id, plant.axes[id].first_segment });
        return places;
    }
    std::vector<SegmentId> first(plant.axes.size(), kNone);
    for (auto const segment : indicator.below)
        for (auto const& rest : subtree_of(plant, segment))
            first[rest.axis] = std::min(first[rest.axis], rest.first);
    for (AxisId id = 0; id < plant.axes.size(); ++id)
        if (first[id] != kNone)
            places.push_back({ id, first[id] });
    return places;
}

} // namespace

Result<Influence> influence_of(Plant const& plant, std::span<Vec3 const> nodes_mm,
                               std::span<MotionIndicator const> indicators, ShownPlant const& shown)
{
    Influence influence;
    if (indicators.empty())
        return influence;
    if (!(shown.height_mm > 0 && shown.scale > 0))
        return fail(Fault::User,
                    fmt::format("the motion indicators are measured against a plant shown {} mm "
                                "high: show it above 0 mm",
                                shown.height_mm));
    Vec3 sum_mm = Vec3::Zero();
    for (auto const& indicator : indicators) {
        TRY(check_indicator(plant, indicator));
        if (!indicator.is_local() && !indicator.is_orphaned)
            sum_mm += indicator.end_mm - indicator.start_mm;
    }
    influence.everywhere = sum_mm / shown.height_mm;
    for (auto const& indicator : indicators) {
        if (!indicator.is_local() || indicator.is_orphaned)
            continue;
        influence.local.resize(plant.segment_count(), Vec3::Zero());
        add_local(plant, nodes_mm, LocalInfluence(indicator, shown), places_of(plant, indicator),
                  influence.local);
    }
    return influence;
}

} // namespace tractus::variation
