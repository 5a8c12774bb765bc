#include "engine/variation/diversity.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::variation {

static constexpr std::size_t kNodes = 2000;

static DistanceSpread spread_of(std::span<double const> distances_mm)
{
    DistanceSpread spread { .count = distances_mm.size() };
    if (distances_mm.empty())
        return spread;
    auto const count = static_cast<double>(distances_mm.size());
    for (double const distance : distances_mm)
        spread.mean_mm += distance / count;
    if (distances_mm.size() == 1)
        return spread;
    double squares = 0;
    for (double const distance : distances_mm)
        squares += (distance - spread.mean_mm) * (distance - spread.mean_mm);
    spread.deviation_mm = std::sqrt(squares / (count - 1));
    return spread;
}

double distance_mm(std::span<Vec3 const> one, std::span<Vec3 const> other)
{
    CHECK(one.size() == other.size());
    if (one.empty())
        return 0;
    double squares = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        squares += (one[i] - other[i]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(one.size()));
}

Diversity::Diversity(Plant const& drawn)
    : axes_(drawn.axes)
{
    auto const nodes = drawn.node_position_mm.size();
    auto const stride = std::max<std::size_t>(1, nodes / kNodes);
    AddressIndex const index(drawn);
    AxisId axis = 0;
    for (std::size_t i = 0; i < nodes; i += stride) {
        while (axis < axes_.size() && i > axes_[axis].first_node + axes_[axis].segment_count)
            ++axis;
        Place place { .node = static_cast<NodeId>(i) };
        if (axis < axes_.size()) {
            auto const steps = place.node - axes_[axis].first_node;
            place.is_base = steps == 0;
            place.segment
                = index.address_of(drawn, axes_[axis].first_segment + (steps ? steps - 1 : 0));
        }
        places_.push_back(std::move(place));
        drawn_mm_.push_back(drawn.node_position_mm[i]);
    }
}

bool Diversity::is_like_drawn(Plant const& plant) const
{
    return std::equal(axes_.begin(), axes_.end(), plant.axes.begin(), plant.axes.end(),
                      [](Axis const& one, Axis const& other) {
                          return one.parent_segment == other.parent_segment
                              && one.segment_count == other.segment_count;
                      });
}

// Returns the position of the tip of the segment at an address (`is_base`: of its base). If there
// is no such segment, returns the tip of the last existing segment on the path to it from the
// ground.
static Vec3 position_at(Plant const& plant, AddressIndex const& index, SegmentAddress address,
                        bool is_base)
{
    while (!address.empty()) {
        if (auto const found = index.find_segment(plant, address)) {
            auto const& axis = plant.axes[axis_of(plant, *found)];
            auto const end = axis.first_node + (*found - axis.first_segment) + 1;
            return plant.node_position_mm[is_base ? end - 1 : end];
        }
        is_base = false;
        if (address.back() > 0)
            --address.back();
        else
            address.resize(address.size() - 2);
    }
    return plant.node_position_mm.empty() ? Vec3(Vec3::Zero()) : plant.node_position_mm.front();
}

std::vector<Vec3> Diversity::positions_in(Plant const& plant) const
{
    std::vector<Vec3> positions_mm;
    if (is_like_drawn(plant)) {
        for (auto const& place : places_)
            positions_mm.push_back(plant.node_position_mm[place.node]);
        return positions_mm;
    }
    AddressIndex const index(plant);
    for (auto const& place : places_)
        positions_mm.push_back(position_at(plant, index, place.segment, place.is_base));
    return positions_mm;
}

void Diversity::add(Plant const& plant)
{
    plants_mm_.push_back(positions_in(plant));
}

DistanceSpread Diversity::between_plants() const
{
    std::vector<double> distances_mm;
    for (std::size_t i = 0; i < plants_mm_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            distances_mm.push_back(distance_mm(plants_mm_[i], plants_mm_[j]));
    return spread_of(distances_mm);
}

DistanceSpread Diversity::from_drawn() const
{
    std::vector<double> distances_mm;
    for (auto const& plant : plants_mm_)
        distances_mm.push_back(distance_mm(plant, drawn_mm_));
    return spread_of(distances_mm);
}

} // namespace tractus::variation
