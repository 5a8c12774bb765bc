#include "engine/methods/construction_lines/function_curves.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>

namespace tractus::lines {

namespace {

// Half-width of the plateau around a node, as a share of the stem's length. A table lookup reads
// the two samples around a position, each off by up to 0.001.
constexpr double kPlateau = 0.001 + 1.3 / (kFunctionSamples - 1);

// Returns the half-width of the plateau around node `i`: kPlateau, or less where nodes are close
// together.
double plateau_of(std::vector<OrganNode> const& nodes, std::size_t i)
{
    double half = kPlateau;
    if (i > 0)
        half = std::min(half, (nodes[i].x - nodes[i - 1].x) / 4);
    if (i + 1 < nodes.size())
        half = std::min(half, (nodes[i + 1].x - nodes[i].x) / 4);
    return half;
}

// True if the midpoints of the stem pieces before and behind a node lie well outside the node's
// plateau; a piece is at least half of kShortPiece long.
bool has_room(std::vector<OrganNode> const& nodes, std::size_t i)
{
    constexpr double kRoom = kShortPiece / 2;
    return (i == 0 || nodes[i].x - nodes[i - 1].x >= kRoom)
        && (i + 1 == nodes.size() || nodes[i + 1].x - nodes[i].x >= kRoom);
}

// The turtle's heading at a node. If there is room for a plateau, it is the stem's tangent, so that
// organs around the stem have exact angles; otherwise it is the stem's smoothed course.
DrawnStem::Course heading_at_node(Construction const& construction, std::size_t i)
{
    auto const& stem = construction.stem;
    double const x = construction.nodes[i].x;
    if (has_room(construction.nodes, i))
        return { stem.heading_deg(x), stem.pitch_deg(x) };
    return stem.course(x);
}

// Adapts points to the format that cpfg accepts: x from 0 to 1, ascending in six digits, at least
// four points.
std::vector<Vec2> tidy_points(std::vector<Vec2> const& points)
{
    constexpr double kMinStep = 2e-6;
    std::vector<Vec2> result;
    for (auto const& point : points) {
        double const x = std::clamp(point.x(), 0.0, 1.0);
        if (result.empty() || x >= result.back().x() + kMinStep)
            result.emplace_back(x, point.y());
    }
    result.front().x() = 0;
    if (result.back().x() < 1 - kMinStep)
        result.emplace_back(1, points.back().y());
    result.back().x() = 1;
    while (result.size() < 4)
        result.insert(result.begin() + 1, (result[0] + result[1]) / 2);
    return result;
}

// A function of the position on the stem that is linear between nodes and constant beyond them.
FunctionCurve node_curve(std::vector<OrganNode> const& nodes, std::string const& name,
                         std::vector<double> const& values)
{
    std::vector<Vec2> points { Vec2(0, values.front()) };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double const half = plateau_of(nodes, i);
        points.emplace_back(nodes[i].x - half, values[i]);
        points.emplace_back(nodes[i].x + half, values[i]);
    }
    return { name, tidy_points(points) };
}

FunctionCurve node_curve(std::vector<OrganNode> const& nodes, std::string const& name,
                         double OrganNode::*value)
{
    std::vector<double> values;
    for (auto const& node : nodes)
        values.push_back(node.*value);
    return node_curve(nodes, name, values);
}

// Positions at which a stem's course is sampled: at even steps, beside each plateau, and half-way
// between nodes.
std::vector<double> course_places(std::vector<OrganNode> const& nodes)
{
    constexpr int kSteps = 400;
    constexpr double kBeside = 3e-4;
    std::vector<double> places;
    for (int i = 0; i <= kSteps; ++i)
        places.push_back(static_cast<double>(i) / kSteps);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double const half = plateau_of(nodes, i) + kBeside;
        places.push_back(nodes[i].x - half);
        places.push_back(nodes[i].x + half);
        if (i > 0)
            places.push_back((nodes[i - 1].x + nodes[i].x) / 2);
    }
    std::sort(places.begin(), places.end());
    return places;
}

FunctionCurve stem_curve(Construction const& construction, std::string const& name,
                         double DrawnStem::Course::*value)
{
    auto const& nodes = construction.nodes;
    auto const value_at = [&](double x) { return construction.stem.course(x).*value; };
    std::vector<Vec2> points;
    std::size_t next = 0; // Index of the first node whose plateau has not been added.
    auto const add_plateau = [&] {
        double const half = plateau_of(nodes, next);
        double const at_node = heading_at_node(construction, next).*value;
        points.emplace_back(nodes[next].x - half, at_node);
        points.emplace_back(nodes[next].x + half, at_node);
        ++next;
    };
    for (double const x : course_places(nodes)) {
        while (next < nodes.size() && nodes[next].x <= x)
            add_plateau();
        auto const is_on
            = [&](std::size_t i) { return std::fabs(x - nodes[i].x) <= plateau_of(nodes, i); };
        bool const on_plateau
            = (next > 0 && is_on(next - 1)) || (next < nodes.size() && is_on(next));
        if (x >= 0 && x <= 1 && !on_plateau)
            points.emplace_back(x, value_at(x));
    }
    return { name, tidy_points(points) };
}

// Converts an organ's angle and length from the stem's tangent to the turtle's heading, without
// changing how the organ looks on the sheet.
Reach turned_reach(Reach const& organ, double turn_deg, double tangent_pitch_deg, double pitch_deg)
{
    auto seen = as_projected(organ, tangent_pitch_deg);
    seen.angle_deg += turn_deg;
    return in_space(seen, pitch_deg);
}

std::vector<OrganNode> turned_nodes(Construction const& construction)
{
    auto const& stem = construction.stem;
    auto nodes = construction.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        auto& node = nodes[i];
        auto const heading = heading_at_node(construction, i);
        double const turn_deg = stem.heading_deg(node.x) - heading.heading_deg;
        double const pitch_deg = stem.pitch_deg(node.x);
        auto const left = turned_reach({ node.left_deg, node.left_size }, turn_deg, pitch_deg,
                                       heading.pitch_deg);
        auto const right = turned_reach({ node.right_deg, node.right_size }, -turn_deg, pitch_deg,
                                        heading.pitch_deg);
        node = { node.x, left.angle_deg, right.angle_deg, left.length, right.length };
    }
    return nodes;
}

// Distance from each node to the next, from the base to the first node, and from the last node to
// the top. The function changes half-way between nodes, so that its value at a node is exact.
FunctionCurve internode_curve(Construction const& construction)
{
    std::vector<double> places { 0 };
    for (auto const& node : construction.nodes)
        places.push_back(node.x);
    places.push_back(1);
    std::vector<Vec2> points { Vec2(0, places[1]) };
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        double const before = places[i] - places[i - 1];
        double const after = places[i + 1] - places[i];
        double const middle = places[i] - before / 2;
        double const half = std::min(kPlateau, before / 8);
        if (std::fabs(after - before) > 1e-9) {
            points.emplace_back(middle - half, before);
            points.emplace_back(middle + half, after);
        }
    }
    points.emplace_back(1, points.back().y());
    return { "internode", tidy_points(points) };
}

} // namespace

std::vector<FunctionCurve> function_curves(Construction const& construction)
{
    auto const nodes = turned_nodes(construction);
    std::vector<FunctionCurve> curves {
        stem_curve(construction, "heading", &DrawnStem::Course::heading_deg),
        stem_curve(construction, "depth", &DrawnStem::Course::pitch_deg),
        node_curve(nodes, "angle_left", &OrganNode::left_deg),
        node_curve(nodes, "angle_right", &OrganNode::right_deg),
        node_curve(nodes, "size_left", &OrganNode::left_size),
        node_curve(nodes, "size_right", &OrganNode::right_size),
        internode_curve(construction)
    };
    for (auto const& side : construction.around) {
        auto const name = fmt::format("size_around_{}", curves.size() + 1 - kFunctionsOfSides);
        if (side.azimuth_deg == 0)
            curves.push_back(node_curve(nodes, name, &OrganNode::left_size));
        else if (side.azimuth_deg == 180)
            curves.push_back(node_curve(nodes, name, &OrganNode::right_size));
        else
            curves.push_back(node_curve(nodes, name, side.sizes));
    }
    return curves;
}

std::string function_file(FunctionCurve const& curve)
{
    auto text = fmt::format("fver 1 1\nname: {}\nsamples: {}\nflip: off\npoints: {}\n", curve.name,
                            kFunctionSamples, curve.points.size());
    for (auto const& point : curve.points)
        fmt::format_to(std::back_inserter(text), "{:.6f} {:.6f} 3\n", point.x(), point.y() + 0.0);
    return text;
}

} // namespace tractus::lines
