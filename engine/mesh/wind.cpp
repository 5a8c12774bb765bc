#include "engine/mesh/wind.h"

#include "engine/base/random.h"
#include "engine/mesh/section_rings.h"

#include <bit>

namespace tractus::mesh {

namespace {

constexpr std::uint32_t kPhases = 0x7068; // Random stream of the axes' phases.

// Returns a hash of the position of a branch's tip. Unlike the branch's index, it is the same in
// every level of detail.
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

template<typename Sections>
void bend(Sections const& sections, TubePart const& part, std::span<WindVertex> to)
{
    double const length = sections.stations.back().arc_mm;
    for_each_ring(sections, part, to.size(), [&](std::uint32_t station, std::size_t count) {
        for (auto& vertex : to.first(count))
            vertex.bend = static_cast<float>(sections.stations[station].arc_mm / length);
        to = to.subspan(count);
    });
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
    bend(spine, part, to);
}

void bend_extrusion(Extrusion const& extrusion, TubePart const& part, std::span<WindVertex> to)
{
    bend(extrusion, part, to);
}

} // namespace tractus::mesh
