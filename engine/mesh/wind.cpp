#include "engine/mesh/wind.h"

#include "engine/base/random.h"

#include <bit>

namespace tractus {

namespace {

constexpr std::uint32_t kPhases = 0x7068; // The random stream of phases.

// Names a branch by where its tip is, which unlike its number is the same in every level of detail.
std::uint64_t name_of(Vec3 const& tip_mm)
{
    std::uint64_t name = 0;
    for (double const part : { tip_mm.x(), tip_mm.y(), tip_mm.z() })
        name = 0x9E3779B97F4A7C15u * (name ^ std::bit_cast<std::uint64_t>(part)) + (name >> 31);
    return name;
}

double length_to(std::span<Vec3 const> nodes, std::uint32_t end)
{
    double length = 0;
    for (std::uint32_t i = 0; i < end; ++i)
        length += (nodes[i + 1] - nodes[i]).norm();
    return length;
}

// Gives `count` vertices a share of the axis' length.
std::span<WindVertex> give(std::span<WindVertex> to, std::size_t count, double share)
{
    for (auto& vertex : to.first(count))
        vertex.bend = static_cast<float>(share);
    return to.subspan(count);
}

} // namespace

WindVertex wind_of(Plant const& plant, Axis const& axis, WindKey const& key)
{
    auto const nodes = plant.positions(axis);
    Vec3 const way = nodes.back() - nodes.front();
    WindVertex wind;
    wind.pivot_mm = nodes.front().cast<float>();
    if (way.norm() > 0)
        wind.axis = way.normalized().cast<float>();
    wind.level = static_cast<float>(axis.order);
    auto const block = random_block({ key.seed, kPhases, key.plant }, name_of(nodes.back()));
    wind.phase = static_cast<float>(block[0] >> 8) * 0x1p-24f;
    return wind;
}

WindVertex wind_at(Plant const& plant, SegmentId segment, WindKey const& key)
{
    if (segment == kNone)
        return {};
    auto const& axis = plant.axes[axis_of(plant, segment)];
    auto wind = wind_of(plant, axis, key);
    auto const nodes = plant.positions(axis);
    double const length = length_to(nodes, axis.segment_count);
    if (length > 0)
        wind.bend = static_cast<float>(length_to(nodes, segment - axis.first_segment + 1) / length);
    return wind;
}

void bend_tube(Spine const& spine, TubePart const& part, std::span<WindVertex> to)
{
    auto const& stations = spine.stations;
    auto const sides = static_cast<std::size_t>(spine.sides);
    double const length = stations.back().arc_mm;
    bool const has_tip = part.last + 1 == stations.size();
    auto const last_ring = has_tip && spine.tip == Spine::Tip::Point ? part.last - 1 : part.last;
    if (part.first == 0 && spine.closed_base)
        to = give(to, sides, 0);
    for (auto i = part.first; i <= last_ring; ++i)
        to = give(to, sides + 1, stations[i].arc_mm / length);
    give(to, to.size(), 1); // The tip, if it has one.
}

void bend_extrusion(Extrusion const& extrusion, TubePart const& part, std::span<WindVertex> to)
{
    auto const& stations = extrusion.stations;
    double const length = stations.back().arc_mm;
    for (int layer = 0; layer < (extrusion.is_sheet ? 2 : 1); ++layer)
        for (auto i = part.first; i <= part.last; ++i)
            to = give(to, extrusion.sides + 1, stations[i].arc_mm / length);
    // What is left are filled ends, each with as many vertices as the other.
    bool const has_both = part.first == 0 && part.last + 1 == stations.size();
    if (part.first == 0)
        to = give(to, has_both ? to.size() / 2 : to.size(), 0);
    give(to, to.size(), 1);
}

} // namespace tractus
