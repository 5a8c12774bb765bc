#include "engine/methods/construction_lines/measure_nodes.h"

#include "engine/methods/construction_lines/around_stem.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace tractus::lines {

namespace {

SideNode measure_node(DrawnStem const& stem, DrawnLine const& boundary, Side side, double x,
                      double angle_deg)
{
    double const at_mm = stem.seen_mm(x);
    Vec2 const way = direction(stem.seen().heading_deg(at_mm) + signed_on(side, angle_deg));
    auto const hit_mm = boundary.nearest_hit_mm(stem.seen().point(at_mm), way);
    auto const reach = in_space({ angle_deg, hit_mm.value_or(0) }, stem.pitch_deg(x));
    SideNode node { x, reach.angle_deg };
    if (hit_mm)
        node.size = reach.length / stem.length_mm();
    return node;
}

// Calls `add_node` for each node with its position on the stem and its organ's angle on one side,
// as seen on the sheet.
template<typename Add> void for_each_node(Construction const& of, Side side, Add const& add_node)
{
    auto const angle_deg = side == Side::Left ? &Inclination::left_deg : &Inclination::right_deg;
    auto const add = [&](Inclination const& low, Inclination const& high, double share) {
        add_node(low.x + share * (high.x - low.x),
                 low.*angle_deg + share * (high.*angle_deg - low.*angle_deg));
    };
    for (std::size_t layer = 0; layer < of.nodes_per_layer.size(); ++layer)
        for (int i = 0; i < of.nodes_per_layer[layer]; ++i)
            add(of.inclinations[layer], of.inclinations[layer + 1],
                static_cast<double>(i) / of.nodes_per_layer[layer]);
    add(of.inclinations[of.inclinations.size() - 2], of.inclinations.back(), 1);
}

} // namespace

char const* name_of_side(Side side)
{
    return side == Side::Left ? "left" : "right";
}

double azimuth_of_side(Side side)
{
    return side == Side::Left ? 0 : 180;
}

double signed_on(Side side, double value)
{
    return static_cast<double>(side) * value;
}

std::vector<SideNode> measure_nodes(Construction const& of, DrawnLine const& boundary, Side side)
{
    std::vector<SideNode> nodes;
    for_each_node(of, side, [&](double x, double angle_deg) {
        nodes.push_back(measure_node(of.stem, boundary, side, x, angle_deg));
    });
    return nodes;
}

std::vector<SideNode> measure_nodes(Construction const& of, std::span<Vec3 const> boundary,
                                    double azimuth_deg)
{
    // Weight of the right side's angle, 0 to 1; the left side's has the rest. Angles are linear in
    // the azimuth.
    double const right = 1 - std::fabs(azimuth_deg / 180 - 1);
    std::vector<SideNode> nodes;
    for (auto const& node : of.nodes) {
        double const angle_deg = (1 - right) * node.left_deg + right * node.right_deg;
        auto const far_mm = reach_mm({ node.x, azimuth_deg, angle_deg }, of.stem, boundary);
        nodes.push_back({ node.x, angle_deg });
        if (far_mm)
            nodes.back().size = *far_mm / of.stem.length_mm();
    }
    return nodes;
}

std::vector<OrganNode> nodes_without_sizes(Construction const& of)
{
    std::vector<OrganNode> nodes;
    auto const in_space_deg = [&](double x, double angle_deg) {
        return in_space({ angle_deg, 0 }, of.stem.pitch_deg(x)).angle_deg;
    };
    for_each_node(of, Side::Left, [&](double x, double angle_deg) {
        nodes.push_back({ x, in_space_deg(x, angle_deg), 0, 0, 0 });
    });
    std::size_t next = 0;
    for_each_node(of, Side::Right, [&](double x, double angle_deg) {
        nodes[next++].right_deg = in_space_deg(x, angle_deg);
    });
    return nodes;
}

SideName side_named(Side side)
{
    return { fmt::format("on the {}", name_of_side(side)),
             fmt::format("the {} boundary", name_of_side(side)) };
}

SideName azimuth_named(double azimuth_deg)
{
    return { fmt::format("{:.0f} degrees around the stem from its left", azimuth_deg),
             "the boundary there" };
}

Result<void> fill_sizes(std::vector<SideNode>& nodes, SideName const& name,
                        std::vector<std::string>& notes)
{
    std::vector<SideNode> known;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(known),
                 [](SideNode const& node) { return node.size.has_value(); });
    if (known.empty())
        return fail(Fault::User,
                    fmt::format("no organ {} meets {}: draw the boundary "
                                "where the inclination lines point",
                                name.where, name.boundary));
    if (auto const missing = nodes.size() - known.size(); missing > 0)
        notes.push_back(fmt::format("{} of {} organs {} miss the boundary: they are as long "
                                    "as their neighbours",
                                    missing, nodes.size(), name.where));
    std::size_t next = 0;
    for (auto& node : nodes) {
        while (next < known.size() && known[next].x < node.x)
            ++next;
        auto const& above = known[std::min(next, known.size() - 1)];
        auto const& below = known[next == 0 ? 0 : next - 1];
        double const gap = above.x - below.x;
        double const share = gap > 0 ? std::clamp((node.x - below.x) / gap, 0.0, 1.0) : 0;
        if (!node.size)
            node.size = *below.size + share * (*above.size - *below.size);
    }
    return {};
}

} // namespace tractus::lines
