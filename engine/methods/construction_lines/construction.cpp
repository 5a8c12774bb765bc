#include "engine/methods/construction_lines/construction.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace tractus::lines {

namespace {

enum class Side { Left = 1, Right = -1 };

char const* name_of_side(Side side)
{
    return side == Side::Left ? "left" : "right";
}

double signed_for(Side side, double value)
{
    return static_cast<double>(side) * value;
}

template<typename Point>
Result<std::vector<Point>> line_points(std::vector<Point> const& points, std::string const& name,
                                       char const* what_to_draw)
{
    constexpr double kFarthest_mm = 1e5;
    for (auto const& point : points)
        if (!(point.array().abs() <= kFarthest_mm).all()) // True for NaN.
            return fail(Fault::User,
                        fmt::format("{} has a point that is farther than {:g} mm away: give "
                                    "its points in millimetres",
                                    name, kFarthest_mm));
    auto result = without_repeats(points);
    if (result.size() < 2)
        return fail(Fault::User,
                    fmt::format("{} is missing or only a dot: draw {}", name, what_to_draw));
    return result;
}

std::size_t count_points(LineSketch const& sketch)
{
    std::size_t points = sketch.stem.size() + sketch.left.size() + sketch.right.size();
    for (auto const& line : sketch.inclinations)
        points += line.size();
    return points;
}

Result<DrawnStem> measure_stem(LineSketch const& sketch)
{
    constexpr double kShortest_mm = 0.01;
    auto const points = TRY(line_points(sketch.stem, "the stem",
                                        "it from the plant's foot to its top, as the first line"));
    DrawnStem stem(points);
    if (stem.length_mm() < kShortest_mm)
        return fail(Fault::User,
                    fmt::format("the stem is only {:g} mm long: draw it from the plant's foot to "
                                "its top",
                                stem.length_mm()));
    return stem;
}

struct Boundaries {
    DrawnLine left;
    DrawnLine right;

    DrawnLine const& of(Side side) const { return side == Side::Left ? left : right; }
};

Result<Boundaries> measure_boundaries(LineSketch const& sketch, DrawnStem const& stem,
                                      std::vector<std::string>& notes)
{
    if (sketch.left.empty() && sketch.right.empty())
        return fail(Fault::User,
                    "there is no boundary: draw the line that the organs' tips reach, "
                    "on the left and on the right of the stem");
    auto const measure = [&](std::vector<Vec2> const& own, std::vector<Vec2> const& other,
                             Side side) -> Result<DrawnLine> {
        auto const name = fmt::format("the {} boundary", name_of_side(side));
        constexpr char const* kWhatToDraw = "the line that the organs' tips reach on this side";
        if (!own.empty())
            return DrawnLine(TRY(line_points(own, name, kWhatToDraw)));
        notes.push_back(name + " is missing: it is the other one, mirrored");
        auto const points = TRY(line_points(other, "the only boundary", kWhatToDraw));
        return DrawnLine(TRY(line_points(mirrored(stem.seen(), points), name, kWhatToDraw)));
    };
    auto left = TRY(measure(sketch.left, sketch.right, Side::Left));
    auto right = TRY(measure(sketch.right, sketch.left, Side::Right));
    return Boundaries { std::move(left), std::move(right) };
}

// An inclination line, where it crosses the stem.
struct CrossingLine {
    DrawnLine const& line;
    std::string name;
    Vec2 at; // On the stem.
    double heading_deg = 0;
    double beside_mm = 0; // What reaches less far from the stem is no half of a line.

    // From -180 to 180, of the way to a point; above 0 on this side of the stem.
    double angle_deg(Side side, Vec2 const& point) const
    {
        Vec2 const way = point - at;
        auto const along = direction(heading_deg);
        return degrees(std::atan2(signed_for(side, cross(along, way)), along.dot(way)));
    }

    bool is_beside(Side side, Vec2 const& point) const
    {
        return signed_for(side, cross(direction(heading_deg), point - at)) > beside_mm;
    }
};

// Where the line meets a boundary: the nearest point on the boundary's side. No value if it does
// not reach it.
Result<std::optional<Vec2>> boundary_point(CrossingLine const& of, DrawnLine const& boundary,
                                           Side side)
{
    std::optional<Vec2> nearest;
    bool meets = false;
    for (auto const& crossing : crossings(boundary, of.line)) {
        auto const point = of.line.point(crossing.second_mm);
        if ((point - of.at).norm() <= kSamePoint_mm)
            continue;
        meets = true;
        if (of.is_beside(side, point)
            && (!nearest || (point - of.at).norm() < (*nearest - of.at).norm()))
            nearest = point;
    }
    if (meets && !nearest)
        return fail(Fault::User,
                    fmt::format("{0} meets the {1} boundary on the {2} of the stem: exchange the "
                                "boundaries, or draw the stem from its foot to its top",
                                of.name, name_of_side(side),
                                name_of_side(side == Side::Left ? Side::Right : Side::Left)));
    return nearest;
}

// No value if the line does not reach out to this side.
Result<std::optional<double>> side_angle_deg(CrossingLine const& of, Boundaries const& boundaries,
                                             Side side)
{
    auto const end = TRY(boundary_point(of, boundaries.of(side), side));
    if (end)
        return of.angle_deg(side, *end);
    for (auto const& point : { of.line.points().front(), of.line.points().back() })
        if (of.is_beside(side, point))
            return of.angle_deg(side, point);
    return std::nullopt;
}

bool crosses_itself(DrawnLine const& line)
{
    constexpr double kLoop = 1e-3; // A smaller one is a point where two pieces join.
    auto const found = crossings(line, line);
    return std::any_of(found.begin(), found.end(), [&](Crossing const& crossing) {
        return std::fabs(crossing.first_mm - crossing.second_mm) > kLoop * line.length_mm();
    });
}

// Where on the stem: seen, mm. On a stem that crosses itself the crossing counts that is nearest to
// the line's middle.
Result<double> stem_crossing_mm(DrawnStem const& stem, DrawnLine const& line,
                                std::string const& name)
{
    auto const found = crossings(stem.seen(), line);
    if (found.empty())
        return fail(Fault::User,
                    fmt::format("{} does not cross the stem: draw it across the stem", name));
    auto const farness = [&](Crossing const& crossing) {
        return std::fabs(crossing.second_mm - line.length_mm() / 2);
    };
    auto const nearest
        = *std::min_element(found.begin(), found.end(), [&](Crossing const& a, Crossing const& b) {
              return farness(a) < farness(b);
          });
    if (found.size() > 1 && !crosses_itself(stem.seen()))
        return fail(Fault::User,
                    fmt::format("{} crosses the stem {} times: draw it so that it crosses once",
                                name, found.size()));
    return std::clamp(nearest.first_mm, 0.0, stem.seen().length_mm());
}

Result<Inclination> measure_inclination(DrawnStem const& stem, Boundaries const& boundaries,
                                        CrossingLine const& of, double at_mm,
                                        std::vector<std::string>& notes)
{
    auto left_deg = TRY(side_angle_deg(of, boundaries, Side::Left));
    auto right_deg = TRY(side_angle_deg(of, boundaries, Side::Right));
    if (!left_deg && !right_deg)
        return fail(Fault::User,
                    fmt::format("{} does not reach out from the stem: draw it across the stem to "
                                "both boundaries",
                                of.name));
    if (!left_deg || !right_deg)
        notes.push_back(fmt::format("{} has no half on the {}: the other half counts on both sides",
                                    of.name, name_of_side(left_deg ? Side::Right : Side::Left)));
    return Inclination { std::clamp(stem.place(at_mm), 0.0, 1.0), left_deg ? *left_deg : *right_deg,
                         right_deg ? *right_deg : *left_deg, 0 };
}

Result<void> check_apart(std::vector<Inclination> const& sorted)
{
    constexpr double kClosest = 1e-5; // What six digits tell apart.
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i].x - sorted[i - 1].x < kClosest)
            return fail(Fault::User,
                        fmt::format("inclination lines {} and {} from below cross the stem at "
                                    "the same place: draw them apart",
                                    i, i + 1));
    return {};
}

// Where organs stand as long as no lines say it, from so far up to so far.
constexpr double kLowest = 0.1;
constexpr double kTopmost = 0.95;

std::vector<Inclination> all_along(double left_deg, double right_deg)
{
    return { { kLowest, left_deg, right_deg }, { kTopmost, left_deg, right_deg } };
}

Result<std::vector<Inclination>> sorted(std::vector<Inclination> lines)
{
    std::sort(lines.begin(), lines.end(),
              [](Inclination const& a, Inclination const& b) { return a.x < b.x; });
    TRY(check_apart(lines));
    return lines;
}

std::string name_of_line(std::size_t number)
{
    return fmt::format("inclination line {}", number + 1);
}

Result<DrawnLine> inclination_line(LineSketch const& sketch, std::size_t number)
{
    return DrawnLine(
        TRY(line_points(sketch.inclinations[number], name_of_line(number), "it across the stem")));
}

Result<std::vector<Inclination>> measure_inclinations(LineSketch const& sketch,
                                                      DrawnStem const& stem,
                                                      Boundaries const& boundaries, Missing missing,
                                                      std::vector<std::string>& notes)
{
    if (sketch.inclinations.empty()) {
        notes.emplace_back("there are no inclination lines: organs stand at 45 degrees from 0.1 to "
                           "0.95 of the stem");
        return all_along(45, 45);
    }
    if (sketch.inclinations.size() == 1 && missing == Missing::Refused)
        return fail(Fault::User,
                    "there is only one inclination line: draw a second one across the "
                    "stem, below or above it");
    std::vector<Inclination> result;
    for (std::size_t i = 0; i < sketch.inclinations.size(); ++i) {
        auto const name = name_of_line(i);
        auto const line = TRY(inclination_line(sketch, i));
        double const at_mm = TRY(stem_crossing_mm(stem, line, name));
        CrossingLine const of { line, name, stem.seen().point(at_mm),
                                stem.seen().heading_deg(at_mm), kLeastHalf * stem.length_mm() };
        result.push_back(TRY(measure_inclination(stem, boundaries, of, at_mm, notes)));
        result.back().drawn = i;
    }
    if (result.size() > 1)
        return sorted(std::move(result));
    notes.emplace_back("there is only one inclination line: it holds all along the stem");
    return all_along(result[0].left_deg, result[0].right_deg);
}

// A stem on which nothing stands as long as no boundary says how far it reaches. Where inclination
// lines cross it is known.
Result<Construction> measure_stem_alone(LineSketch const& sketch, DrawnStem stem)
{
    std::vector<Inclination> lines;
    for (std::size_t i = 0; i < sketch.inclinations.size(); ++i) {
        auto const line = TRY(inclination_line(sketch, i));
        double const at_mm = TRY(stem_crossing_mm(stem, line, name_of_line(i)));
        lines.push_back({ std::clamp(stem.place(at_mm), 0.0, 1.0), 45, 45, i });
    }
    lines = lines.size() > 1 ? TRY(sorted(std::move(lines))) : all_along(45, 45);
    return Construction { .stem = std::move(stem),
                          .inclinations = lines,
                          .nodes_per_layer = std::vector<int>(lines.size() - 1, 0),
                          .nodes = { { lines.back().x, 45, 45, 0, 0 } },
                          .notes = { "there is no boundary: nothing stands on the stem" } };
}

// From below.
std::vector<int> nodes_of_layers(LineSketch const& sketch, std::vector<Inclination> const& lines)
{
    if (sketch.nodes_above.empty())
        return sketch.nodes_per_layer;
    CHECK(sketch.nodes_above.size() == std::max<std::size_t>(1, sketch.inclinations.size()));
    std::vector<int> nodes;
    for (std::size_t layer = 0; layer + 1 < lines.size(); ++layer)
        nodes.push_back(sketch.nodes_above[lines[layer].drawn]);
    return nodes;
}

Result<void> check_nodes(std::vector<int> const& nodes, std::size_t layers)
{
    if (nodes.size() != layers)
        return fail(Fault::User,
                    fmt::format("the inclination lines have {} layer{} between them, but there are "
                                "numbers of nodes for {}: give one number for each layer",
                                layers, layers == 1 ? "" : "s", nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i] < 0 || nodes[i] > kMostNodesInLayer)
            return fail(Fault::User,
                        fmt::format("layer {} is to have {} nodes: give 0 to {}", i + 1, nodes[i],
                                    kMostNodesInLayer));
    if (auto const count = std::accumulate(nodes.begin(), nodes.end(), 1); count > kMostNodes)
        return fail(
            Fault::User,
            fmt::format("the layers have {} nodes together: give at most {}", count, kMostNodes));
    return {};
}

// The nodes' angles and sizes on one side. No size where the ray misses the boundary.
struct SideNode {
    double x = 0;
    double angle_deg = 0;
    std::optional<double> size {};
};

SideNode measure_node(DrawnStem const& stem, DrawnLine const& boundary, Side side, double x,
                      double angle_deg)
{
    double const at_mm = stem.seen_mm(x);
    Vec2 const way = direction(stem.seen().heading_deg(at_mm) + signed_for(side, angle_deg));
    auto const hit_mm = boundary.nearest_hit_mm(stem.seen().point(at_mm), way);
    auto const reach = in_space({ angle_deg, hit_mm.value_or(0) }, stem.pitch_deg(x));
    SideNode node { x, reach.angle_deg };
    if (hit_mm)
        node.size = reach.length / stem.length_mm();
    return node;
}

std::vector<SideNode> measure_nodes(Construction const& of, DrawnLine const& boundary, Side side)
{
    auto const angle_deg = side == Side::Left ? &Inclination::left_deg : &Inclination::right_deg;
    std::vector<SideNode> nodes;
    auto const add = [&](Inclination const& low, Inclination const& high, double share) {
        nodes.push_back(measure_node(of.stem, boundary, side, low.x + share * (high.x - low.x),
                                     low.*angle_deg + share * (high.*angle_deg - low.*angle_deg)));
    };
    for (std::size_t layer = 0; layer < of.nodes_per_layer.size(); ++layer)
        for (int i = 0; i < of.nodes_per_layer[layer]; ++i)
            add(of.inclinations[layer], of.inclinations[layer + 1],
                static_cast<double>(i) / of.nodes_per_layer[layer]);
    add(of.inclinations[of.inclinations.size() - 2], of.inclinations.back(), 1);
    return nodes;
}

// Sizes that are missing, linear between those of the nearest nodes that have one.
Result<void> fill_sizes(std::vector<SideNode>& nodes, Side side, std::vector<std::string>& notes)
{
    std::vector<SideNode> known;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(known),
                 [](SideNode const& node) { return node.size.has_value(); });
    if (known.empty())
        return fail(Fault::User,
                    fmt::format("no organ on the {0} meets the {0} boundary: draw the boundary "
                                "where the inclination lines point",
                                name_of_side(side)));
    if (auto const missing = nodes.size() - known.size(); missing > 0)
        notes.push_back(fmt::format("{} of {} organs on the {} miss the boundary: they are as long "
                                    "as their neighbours",
                                    missing, nodes.size(), name_of_side(side)));
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

} // namespace

Result<void> check_point_count(std::size_t points)
{
    if (points > kMostPoints)
        return fail(Fault::User,
                    fmt::format("the sketch's lines have {} points together, more than {}: leave "
                                "out points that lie close together",
                                points, kMostPoints));
    return {};
}

// A stem that points at the viewer shows nothing of itself.
static double foreshortening(double pitch_deg)
{
    constexpr double kLeast = 0.17;
    return std::max(std::cos(radians(pitch_deg)), kLeast);
}

static Reach stretched(Reach const& reach, double along)
{
    double const sine = std::sin(radians(reach.angle_deg));
    double const cosine = std::cos(radians(reach.angle_deg)) * along;
    return { degrees(std::atan2(sine, cosine)), reach.length * std::hypot(sine, cosine) };
}

Reach in_space(Reach const& seen, double pitch_deg)
{
    return stretched(seen, 1 / foreshortening(pitch_deg));
}

Reach as_seen(Reach const& organ, double pitch_deg)
{
    return stretched(organ, foreshortening(pitch_deg));
}

bool has_boundary(LineSketch const& sketch)
{
    return !sketch.left.empty() || !sketch.right.empty();
}

Result<Construction> measure_sketch(LineSketch const& sketch, Missing missing)
{
    TRY(check_point_count(count_points(sketch)));
    auto stem = TRY(measure_stem(sketch));
    if (missing == Missing::Guessed && !has_boundary(sketch))
        return measure_stem_alone(sketch, std::move(stem));
    Construction result {
        .stem = std::move(stem), .inclinations = {}, .nodes_per_layer = {}, .nodes = {}, .notes = {}
    };
    auto const boundaries = TRY(measure_boundaries(sketch, result.stem, result.notes));
    result.inclinations
        = TRY(measure_inclinations(sketch, result.stem, boundaries, missing, result.notes));
    result.nodes_per_layer = nodes_of_layers(sketch, result.inclinations);
    TRY(check_nodes(result.nodes_per_layer, result.inclinations.size() - 1));
    auto left = measure_nodes(result, boundaries.left, Side::Left);
    auto right = measure_nodes(result, boundaries.right, Side::Right);
    TRY(fill_sizes(left, Side::Left, result.notes));
    TRY(fill_sizes(right, Side::Right, result.notes));
    for (std::size_t i = 0; i < left.size(); ++i)
        result.nodes.push_back(
            { left[i].x, left[i].angle_deg, right[i].angle_deg, *left[i].size, *right[i].size });
    return result;
}

FunctionValues values_at(Construction const& construction, double x)
{
    auto const& nodes = construction.nodes;
    auto const above
        = std::upper_bound(nodes.begin(), nodes.end(), x,
                           [](double at, OrganNode const& node) { return at < node.x; });
    auto const& high = above == nodes.end() ? nodes.back() : *above;
    auto const& low = above == nodes.begin() ? nodes.front() : *(above - 1);
    double const gap = high.x - low.x;
    double const share = gap > 0 ? (x - low.x) / gap : 0;
    auto const between
        = [&](double OrganNode::*value) { return low.*value + share * (high.*value - low.*value); };
    return { construction.stem.heading_deg(x), construction.stem.pitch_deg(x),
             between(&OrganNode::left_deg),    between(&OrganNode::right_deg),
             between(&OrganNode::left_size),   between(&OrganNode::right_size) };
}

} // namespace tractus::lines
