#include "engine/methods/construction_lines/construction.h"

#include "engine/base/check.h"
#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/measure_boundaries.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace tractus::lines {

namespace {

std::size_t count_points(LineSketch const& sketch)
{
    std::size_t points = sketch.stem.size() + sketch.left.size() + sketch.right.size();
    for (auto const& line : sketch.inclinations)
        points += line.size();
    for (auto const& line : sketch.around)
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

// An inclination line and the place where it crosses the stem.
struct CrossingLine {
    DrawnLine const& line;
    std::string name;
    Vec2 at; // Crossing point on the stem.
    double heading_deg = 0;
    // Minimum reach of the line from the stem on a side, to have a half there.
    double beside_mm = 0;

    // Angle from the stem's heading to the direction from the crossing to a point, -180 to 180
    // degrees, positive if the point is on the given side of the stem.
    double angle_deg(Side side, Vec2 const& point) const
    {
        Vec2 const way = point - at;
        auto const along = direction(heading_deg);
        return degrees(std::atan2(signed_on(side, cross(along, way)), along.dot(way)));
    }

    bool is_beside(Side side, Vec2 const& point) const
    {
        return signed_on(side, cross(direction(heading_deg), point - at)) > beside_mm;
    }
};

// Returns the nearest point on the given side of the stem at which an inclination line meets a
// boundary. No value if the line does not reach the boundary. Fails with a user error if it meets
// the boundary only on the other side.
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

// Returns the angle of an inclination line to the stem on one side; no value if the line does not
// reach out to that side.
Result<std::optional<double>> side_angle_deg(CrossingLine const& of, Boundaries const& boundaries,
                                             Side side)
{
    auto const boundary = seen_on_side(boundaries, side);
    auto const end = boundary ? boundary_point(of, *boundary, side) : std::nullopt;
    // A boundary in space may appear on the other side of the stem, so the failure counts only for
    // boundaries on the sheet.
    if (!end && boundaries.of(side))
        return fail(end.error().fault, end.error().message);
    if (end && *end)
        return of.angle_deg(side, **end);
    for (auto const& point : { of.line.points().front(), of.line.points().back() })
        if (of.is_beside(side, point))
            return of.angle_deg(side, point);
    return std::nullopt;
}

bool crosses_itself(DrawnLine const& line)
{
    // Minimum size of a loop, as a share of the line's length: below it, two segments merely join.
    constexpr double kLoop = 1e-3;
    auto const found = crossings(line, line);
    return std::any_of(found.begin(), found.end(), [&](Crossing const& crossing) {
        return std::fabs(crossing.first_mm - crossing.second_mm) > kLoop * line.length_mm();
    });
}

// Distance along the stem's projection at which a line crosses it. Of several crossings the one
// nearest to the line's middle counts.
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
    // Minimum distance between crossings, as a share of the stem's length. Models are written with
    // six digits and could not distinguish closer ones.
    constexpr double kClosest = 1e-5;
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i].x - sorted[i - 1].x < kClosest)
            return fail(Fault::User,
                        fmt::format("inclination lines {} and {} from below cross the stem at "
                                    "the same place: draw them apart",
                                    i, i + 1));
    return {};
}

// Default range of organs along the stem, as shares of the stem's length, if no inclination lines
// are drawn.
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
                                stem.seen().heading_deg(at_mm), kMinHalf * stem.length_mm() };
        result.push_back(TRY(measure_inclination(stem, boundaries, of, at_mm, notes)));
        result.back().drawn = i;
    }
    if (result.size() > 1)
        return sorted(std::move(result));
    notes.emplace_back("there is only one inclination line: it holds all along the stem");
    return all_along(result[0].left_deg, result[0].right_deg);
}

// Measures a stem without boundaries: only the positions of its inclination lines. The organs have
// no size.
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

// Number of nodes in each layer, from below.
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

// Organs of each layer, from below; empty if no layer differs from the whole plant.
std::vector<LayerOrgans> organs_of_layers(LineSketch const& sketch,
                                          std::vector<Inclination> const& lines)
{
    auto const& below = sketch.organs_per_layer;
    auto const& above = sketch.organs_above;
    std::vector<LayerOrgans> organs(lines.size() - 1);
    for (std::size_t layer = 0; layer < organs.size(); ++layer)
        if (!above.empty())
            organs[layer] = above.at(lines[layer].drawn);
        else if (!below.empty())
            organs[layer] = below[std::min(layer, below.size() - 1)];
    bool const differ = std::any_of(organs.begin(), organs.end(), [](LayerOrgans const& layer) {
        return layer != LayerOrgans();
    });
    return differ ? organs : std::vector<LayerOrgans>();
}

Result<void> check_nodes(std::vector<int> const& nodes, std::size_t layers)
{
    if (nodes.size() != layers)
        return fail(Fault::User,
                    fmt::format("the inclination lines have {} layer{} between them, but there are "
                                "numbers of nodes for {}: give one number for each layer",
                                layers, layers == 1 ? "" : "s", nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i] < 0 || nodes[i] > kMaxNodesInLayer)
            return fail(Fault::User,
                        fmt::format("layer {} is to have {} nodes: give 0 to {}", i + 1, nodes[i],
                                    kMaxNodesInLayer));
    if (auto const count = std::accumulate(nodes.begin(), nodes.end(), 1); count > kMaxNodes)
        return fail(
            Fault::User,
            fmt::format("the layers have {} nodes together: give at most {}", count, kMaxNodes));
    return {};
}

} // namespace

Result<void> check_point_count(std::size_t points)
{
    if (points > kMaxPoints)
        return fail(Fault::User,
                    fmt::format("the sketch's lines have {} points together, more than {}: leave "
                                "out points that lie close together",
                                points, kMaxPoints));
    return {};
}

// Apparent length of a stem with this pitch towards the viewer, as a share of its true length. It
// has a lower limit, because a stem pointing at the viewer shows no length.
static double foreshortening(double pitch_deg)
{
    constexpr double kMin = 0.17;
    return std::max(std::cos(radians(pitch_deg)), kMin);
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

Reach as_projected(Reach const& organ, double pitch_deg)
{
    return stretched(organ, foreshortening(pitch_deg));
}

bool has_boundary(LineSketch const& sketch)
{
    return !sketch.left.empty() || !sketch.right.empty() || !sketch.around.empty();
}

// Measures the nodes if all boundaries lie on the sheet, the only case in Anastacio et al. 2008.
static Result<void> measure_sides(Construction& of, Boundaries const& boundaries)
{
    auto left = measure_nodes(of, *boundaries.left, Side::Left);
    auto right = measure_nodes(of, *boundaries.right, Side::Right);
    TRY(fill_sizes(left, side_named(Side::Left), of.notes));
    TRY(fill_sizes(right, side_named(Side::Right), of.notes));
    for (std::size_t i = 0; i < left.size(); ++i)
        of.nodes.push_back(
            { left[i].x, left[i].angle_deg, right[i].angle_deg, *left[i].size, *right[i].size });
    return {};
}

static Result<void> add_azimuth(Construction& of, double azimuth_deg, std::vector<SideNode> nodes,
                                SideName const& name)
{
    TRY(fill_sizes(nodes, name, of.notes));
    AzimuthSizes& added = of.around.emplace_back();
    added.azimuth_deg = azimuth_deg;
    for (auto const& node : nodes)
        added.sizes.push_back(*node.size);
    return {};
}

static Result<void> measure_all_around(Construction& of, Boundaries const& boundaries)
{
    of.nodes = nodes_without_sizes(of);
    for (auto const side : { Side::Left, Side::Right })
        if (boundaries.of(side))
            TRY(add_azimuth(of, azimuth_of_side(side),
                            measure_nodes(of, *boundaries.of(side), side), side_named(side)));
    for (auto const& line : boundaries.around)
        TRY(add_azimuth(of, line.azimuth_deg, measure_nodes(of, line.points, line.azimuth_deg),
                        azimuth_named(line.azimuth_deg)));
    std::sort(of.around.begin(), of.around.end(), [](AzimuthSizes const& a, AzimuthSizes const& b) {
        return a.azimuth_deg < b.azimuth_deg;
    });
    for (std::size_t i = 0; i < of.nodes.size(); ++i) {
        of.nodes[i].left_size = size_at(of, i, azimuth_of_side(Side::Left));
        of.nodes[i].right_size = size_at(of, i, azimuth_of_side(Side::Right));
    }
    return {};
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
    result.organs_per_layer = organs_of_layers(sketch, result.inclinations);
    TRY(check_nodes(result.nodes_per_layer, result.inclinations.size() - 1));
    if (boundaries.around.empty())
        TRY(measure_sides(result, boundaries));
    else
        TRY(measure_all_around(result, boundaries));
    return result;
}

double size_at(Construction const& construction, std::size_t node, double azimuth_deg)
{
    auto const& around = construction.around;
    if (around.empty()) {
        auto const& sizes = construction.nodes[node];
        double const right = 1 - std::fabs(azimuth_deg / 180 - 1);
        return (1 - right) * sizes.left_size + right * sizes.right_size;
    }
    auto const count = around.size();
    // The last interval, from the last boundary to the first, also contains azimuths below that of
    // the first boundary.
    std::size_t low = count - 1;
    for (std::size_t i = 0; i < count && around[i].azimuth_deg <= azimuth_deg; ++i)
        low = i;
    auto const turn = [](double from_deg, double to_deg) {
        double const by_deg = to_deg - from_deg;
        return by_deg < 0 ? by_deg + 360 : by_deg;
    };
    auto const gap_behind = [&](std::size_t i) {
        return count == 1 ? 360 : turn(around[i].azimuth_deg, around[(i + 1) % count].azimuth_deg);
    };
    auto const high = (low + 1) % count;
    auto const before = (low + count - 1) % count;
    auto const size_of = [&](std::size_t i) { return around[i % count].sizes[node]; };
    return size_between({ size_of(low), size_of(high), gap_behind(low), size_of(before),
                          gap_behind(before), size_of(high + 1), gap_behind(high) },
                        turn(around[low].azimuth_deg, azimuth_deg) / gap_behind(low));
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
