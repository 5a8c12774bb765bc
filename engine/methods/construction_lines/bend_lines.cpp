#include "engine/methods/construction_lines/bend_lines.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace tractus::lines {

namespace {

// Maximum number of iterations; each one brings the edited angle or size closer to its target.
constexpr int kMaxRounds = 6;
// A stroke belongs to an inclination line if its distance from the point where the line crosses the
// stem is at most this share of the stem's length.
constexpr double kNearStem = 0.03;

double sign_of(StemSide side)
{
    return side == StemSide::Left ? 1 : -1;
}

StemSide other(StemSide side)
{
    return side == StemSide::Left ? StemSide::Right : StemSide::Left;
}

Result<DrawnLine> flat_line(SketchLine const& line)
{
    std::vector<Vec2> points;
    for (auto const& point : TRY(points_on_sheet(line)))
        points.emplace_back(point.head<2>());
    return DrawnLine(std::move(points));
}

// Returns the line's stroke with `move` applied to the position of each sample on the sheet.
Result<Stroke> moved(SketchLine const& line, std::function<Vec2(Vec2 const& sheet_mm)> const& move)
{
    auto tips = TRY(line.stroke.tips.in_memory()).vector();
    for (auto& tip : tips) {
        Vec2 const to_mm = move(line.sheet.on_sheet(tip.position_mm.head<2>()));
        tip.position_mm.head<2>() = line.sheet.on_tablet(to_mm);
    }
    auto stroke = line.stroke;
    stroke.tips = SharedVector<TipSample>(std::move(tips));
    return stroke;
}

PenSketch with_stroke(PenSketch sketch, scene::ItemId line, Stroke const& stroke)
{
    for (auto& each : sketch.lines)
        if (each.id == line)
            each.stroke = stroke;
    return sketch;
}

Result<void> refuse(char const* what, double value, double least, double greatest)
{
    if (value >= least && value <= greatest)
        return {};
    return fail(Fault::User,
                fmt::format("{} of {:g} is out of range: {:g} to {:g} are possible", what, value,
                            least, greatest));
}

// The point where an inclination line crosses the stem, and the stem's heading there.
struct OnStem {
    Vec2 at = Vec2::Zero();
    double heading_deg = 0;

    bool is_beside(StemSide side, Vec2 const& place) const
    {
        return sign_of(side) * cross(direction(heading_deg), place - at) > 0;
    }
};

OnStem on_stem(DrawnStem const& stem, double x)
{
    double const at_mm = stem.seen_mm(x);
    return { stem.seen().point(at_mm), stem.seen().heading_deg(at_mm) };
}

bool is_inclination(SketchLine const& line)
{
    return line.role == Role::Inclination || line.role == Role::HalfInclination;
}

// Finds the stroke that forms one half of the inclination line at a crossing: of the strokes that
// reach out to that side, the one that passes nearest to the crossing. Null if there is none.
SketchLine const* line_with_half(PenSketch const& sketch, OnStem const& crossing, StemSide side,
                                 double nearest_mm)
{
    SketchLine const* found = nullptr;
    for (auto const& line : sketch.lines) {
        if (!is_inclination(line))
            continue;
        auto const drawn = flat_line(line);
        if (!drawn)
            continue;
        auto const points = drawn->points();
        bool const reaches
            = crossing.is_beside(side, points.front()) || crossing.is_beside(side, points.back());
        double const away_mm = (drawn->point(drawn->nearest_mm(crossing.at)) - crossing.at).norm();
        if (reaches && away_mm < nearest_mm) {
            nearest_mm = away_mm;
            found = &line;
        }
    }
    return found;
}

Vec2 turned_about(Vec2 const& middle, Vec2 const& place, double by_deg)
{
    return middle + Eigen::Rotation2Dd(by_deg * std::numbers::pi / 180) * (place - middle);
}

double angle_of(Inclination const& line, StemSide side)
{
    return side == StemSide::Left ? line.left_deg : line.right_deg;
}

double size_at(Construction const& construction, double x, StemSide side)
{
    auto const values = values_at(construction, x);
    return side == StemSide::Left ? values.left_size : values.right_size;
}

// The direction of an organ: a ray from the stem towards the boundary.
struct Ray {
    Vec2 from = Vec2::Zero();
    Vec2 way = Vec2::UnitY();
};

Ray ray_at(Construction const& of, double x, StemSide side)
{
    auto const& lines = of.inclinations;
    auto const above = std::find_if(lines.begin(), lines.end(),
                                    [&](Inclination const& line) { return line.x >= x; });
    auto const& high = above == lines.end() ? lines.back() : *above;
    auto const& low = above == lines.begin() || above == lines.end() ? high : *(above - 1);
    double const gap = high.x - low.x;
    double const share = gap > 0 ? (x - low.x) / gap : 0;
    auto const stem = on_stem(of.stem, x);
    double const angle_deg = std::lerp(angle_of(low, side), angle_of(high, side), share);
    return { stem.at, direction(stem.heading_deg + sign_of(side) * angle_deg) };
}

// Returns, for each of size_places(), the arc length along the boundary at which the organs' ray
// meets it; no value if the ray misses the boundary.
std::vector<std::optional<double>> hits(Construction const& of, DrawnLine const& boundary,
                                        StemSide side)
{
    std::vector<std::optional<double>> found;
    for (auto const x : size_places(of)) {
        auto const ray = ray_at(of, x, side);
        auto const far_mm = boundary.nearest_hit_mm(ray.from, ray.way);
        found.push_back(far_mm ? std::optional(boundary.nearest_mm(ray.from + *far_mm * ray.way))
                               : std::nullopt);
    }
    return found;
}

// A smooth weight along a boundary: 1 at the place that is moved, falling to 0 at the neighbouring
// places.
struct Bump {
    double at_mm = 0;
    // Distance before `at_mm` at which the bump ends; `behind_mm`: distance behind it.
    double before_mm = 0;
    double behind_mm = 0;

    double operator()(double place_mm) const
    {
        double const off = place_mm - at_mm;
        double const share = std::min(1.0, std::fabs(off) / (off < 0 ? before_mm : behind_mm));
        return (1 + std::cos(std::numbers::pi * share)) / 2;
    }
};

Bump bump_at(std::vector<std::optional<double>> const& places, std::size_t number,
             DrawnLine const& boundary)
{
    // Minimum reach of a bump to either side, as a share of the boundary's length.
    constexpr double kMinReach = 0.05;
    double const at = *places[number];
    double before = at;
    double behind = boundary.length_mm() - at;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == number || !places[i])
            continue;
        double const off = *places[i] - at;
        (off < 0 ? before : behind) = std::min(off < 0 ? before : behind, std::fabs(off));
    }
    double const least = kMinReach * boundary.length_mm();
    return { at, std::max(before, least), std::max(behind, least) };
}

SketchLine const* boundary_of(PenSketch const& sketch, StemSide side)
{
    auto const role = side == StemSide::Left ? Role::Left : Role::Right;
    auto const found = std::find_if(sketch.lines.rbegin(), sketch.lines.rend(),
                                    [&](SketchLine const& line) { return line.role == role; });
    return found == sketch.lines.rend() ? nullptr : &*found;
}

// A stem bent at one of kHeadingPlaces. The angle of bending falls smoothly to 0 at the
// neighbouring places.
class BentStem {
public:
    BentStem(DrawnLine stem, std::size_t place, double by_deg)
        : before_(std::move(stem))
        , place_(place)
        , by_deg_(by_deg)
        , after_(bent())
    {
    }

    DrawnLine const& before() const { return before_; }

    // Moves a point together with the stem that is bent. `along_mm` is the distance from the stem's
    // foot at which the point is attached to the stem.
    Vec2 moved(Vec2 const& place_mm, double along_mm) const
    {
        return after_.point(along_mm)
            + turned_about(Vec2(0, 0), place_mm - before_.point(along_mm), turn_deg(along_mm));
    }
    Vec2 moved(Vec2 const& place_mm) const { return moved(place_mm, before_.nearest_mm(place_mm)); }

private:
    double turn_deg(double along_mm) const
    {
        double const x = along_mm / before_.length_mm();
        double const off = std::fabs(x - kHeadingPlaces[place_]) / kHeadingPlaces[1];
        return by_deg_ * (1 + std::cos(std::numbers::pi * std::min(1.0, off))) / 2;
    }

    DrawnLine bent() const
    {
        auto const points = before_.points();
        auto const at_mm = before_.at_mm();
        std::vector<Vec2> result { points.front() };
        for (std::size_t i = 1; i < points.size(); ++i)
            result.push_back(result.back()
                             + turned_about(Vec2(0, 0), points[i] - points[i - 1],
                                            turn_deg((at_mm[i - 1] + at_mm[i]) / 2)));
        return DrawnLine(std::move(result));
    }

    DrawnLine before_;
    std::size_t place_;
    double by_deg_;
    DrawnLine after_;
};

// Returns the number of the stem with which a line of the stem `of` moves when `stem` is bent:
// `stem` itself for its own lines. If `of` is attached to `stem`, directly or through other stems,
// it is the one of them that is attached directly. No value if the line does not move.
std::optional<std::size_t> copied_by(PenSketch const& sketch, std::size_t of, std::size_t stem)
{
    for (std::size_t steps = 0; steps <= sketch.lines.size(); ++steps) {
        if (of == stem)
            return of;
        auto const line
            = std::find_if(sketch.lines.begin(), sketch.lines.end(), [&](SketchLine const& each) {
                  return each.role == Role::Stem && each.stem == of;
              });
        if (line == sketch.lines.end() || !line->parent)
            return std::nullopt;
        if (*line->parent == stem)
            return of;
        of = *line->parent;
    }
    return std::nullopt;
}

// Distance along the stem at which a line comes nearest to the stem: where it crosses the stem or
// begins on it.
double meets_mm(DrawnLine const& stem, DrawnLine const& line)
{
    auto const points = line.points();
    auto const away
        = [&](Vec2 const& point) { return (stem.point(stem.nearest_mm(point)) - point).norm(); };
    return stem.nearest_mm(
        *std::min_element(points.begin(), points.end(),
                          [&](Vec2 const& a, Vec2 const& b) { return away(a) < away(b); }));
}

// Returns the sketch with all other lines bent with the stem. Inclination lines and attached stems
// rotate rigidly at the place where they meet the stem; boundaries bend as the stem does.
Result<PenSketch> bent_with(PenSketch sketch, std::size_t stem, BentStem const& bent)
{
    // Distances along the bent stem at which attached stems begin, by stem number.
    std::map<std::size_t, double> feet_mm;
    for (auto const& line : sketch.lines)
        if (line.role == Role::Stem && line.parent == stem)
            feet_mm[line.stem] = bent.before().nearest_mm(TRY(flat_line(line)).points().front());
    auto const before = sketch;
    for (auto& line : sketch.lines) {
        auto const by = copied_by(before, line.stem, stem);
        if (!by)
            continue;
        std::optional<double> at_mm;
        if (*by != stem)
            at_mm = feet_mm[*by];
        else if (is_inclination(line))
            at_mm = meets_mm(bent.before(), TRY(flat_line(line)));
        line.stroke = TRY(moved(line, [&](Vec2 const& place) {
            return at_mm ? bent.moved(place, *at_mm) : bent.moved(place);
        }));
    }
    return sketch;
}

} // namespace

Result<Construction> construction_of(PenSketch const& sketch)
{
    return measure_sketch(TRY(line_sketch(sketch)), Missing::Guessed);
}

// Returns the sketch of only the current stem, whose lines are edited.
static Result<PenSketch> drawing_in_hand(PenSketch const& whole)
{
    return sketch_of_stem(whole, TRY(current_stem(whole)));
}

Result<BentLine> with_angle(PenSketch const& whole, std::size_t number, StemSide side,
                            double angle_deg)
{
    TRY(refuse("an angle", angle_deg, kMinAngle_deg, kGreatestAngle_deg));
    auto const sketch = TRY(drawing_in_hand(whole));
    auto const before = TRY(construction_of(sketch));
    auto const missing = [] {
        return fail(Fault::User, "no inclination line is drawn there: draw it across the stem");
    };
    if (number >= before.inclinations.size())
        return missing();
    auto const& inclination = before.inclinations[number];
    auto const crossing = on_stem(before.stem, inclination.x);
    double const nearest_mm = kNearStem * before.stem.length_mm();
    auto const* line = line_with_half(sketch, crossing, side, nearest_mm);
    if (!line) {
        side = other(side);
        line = line_with_half(sketch, crossing, side, nearest_mm);
    }
    if (!line)
        return missing();
    double by_deg = 0;
    double measured_deg = angle_of(inclination, side);
    BentLine bent { line->id, line->stroke };
    for (int round = 0; round < kMaxRounds && std::fabs(angle_deg - measured_deg) > 0.01; ++round) {
        by_deg += angle_deg - measured_deg;
        bent.stroke = TRY(moved(*line, [&](Vec2 const& place) {
            return crossing.is_beside(side, place)
                ? turned_about(crossing.at, place, sign_of(side) * by_deg)
                : place;
        }));
        auto const after = TRY(construction_of(with_stroke(sketch, line->id, bent.stroke)));
        if (number >= after.inclinations.size())
            return missing();
        measured_deg = angle_of(after.inclinations[number], side);
    }
    return bent;
}

std::vector<double> size_places(Construction const& construction)
{
    std::vector<double> places;
    for (auto const& line : construction.inclinations) {
        if (!places.empty())
            places.push_back((places.back() + line.x) / 2);
        places.push_back(line.x);
    }
    return places;
}

Result<BentLine> with_size(PenSketch const& whole, std::size_t place, StemSide side, double size)
{
    TRY(refuse("a size", size, kMinSize, kGreatestSize));
    auto const sketch = TRY(drawing_in_hand(whole));
    auto const before = TRY(construction_of(sketch));
    auto const* boundary = boundary_of(sketch, side);
    if (!boundary) {
        side = other(side);
        boundary = boundary_of(sketch, side);
    }
    if (!boundary)
        return fail(Fault::User,
                    before.around.empty()
                        ? "there is no boundary: draw the line that the organs' tips reach"
                        : "the boundaries are in space: draw the one on this side again");
    auto const drawn = TRY(flat_line(*boundary));
    auto const places = hits(before, drawn, side);
    if (place >= places.size() || !places[place])
        return fail(Fault::User,
                    "what grows there misses the boundary: draw the boundary where it points");
    auto const ray = ray_at(before, size_places(before)[place], side);
    double const far_mm = (drawn.point(*places[place]) - ray.from).norm();
    auto const bump = bump_at(places, place, drawn);
    double const x = size_places(before)[place];
    double factor = 1;
    double measured = size_at(before, x, side);
    BentLine bent { boundary->id, boundary->stroke };
    for (int round = 0; round < kMaxRounds && std::fabs(size - measured) > 1e-4 && measured > 0;
         ++round) {
        factor *= size / measured;
        bent.stroke = TRY(moved(*boundary, [&](Vec2 const& tip) -> Vec2 {
            return tip + bump(drawn.nearest_mm(tip)) * (factor - 1) * far_mm * ray.way;
        }));
        measured = size_at(TRY(construction_of(with_stroke(sketch, boundary->id, bent.stroke))), x,
                           side);
    }
    return bent;
}

Result<PenSketch> with_heading(PenSketch sketch, scene::ItemId stem, std::size_t place,
                               double heading_deg)
{
    TRY(refuse("a direction", heading_deg, -kGreatestHeading_deg, kGreatestHeading_deg));
    auto const* const found = find_line(sketch, stem);
    if (!found || found->role != Role::Stem || place >= kHeadingPlaces.size())
        return fail(Fault::User, "there is no stem to bend: draw one");
    auto const drawn = TRY(flat_line(*found));
    auto const number = found->stem;
    auto const heading = [&](DrawnLine const& line) {
        return line.heading_deg(kHeadingPlaces[place] * line.length_mm());
    };
    auto const before = sketch;
    double by_deg = 0;
    double measured_deg = heading(drawn);
    for (int round = 0; round < kMaxRounds && std::fabs(heading_deg - measured_deg) > 0.01;
         ++round) {
        by_deg += heading_deg - measured_deg;
        sketch = TRY(bent_with(before, number, BentStem(drawn, place, by_deg)));
        measured_deg = heading(TRY(flat_line(*find_line(sketch, stem))));
    }
    auto const stems = TRY(stem_sketches(sketch));
    TRY(measure_stems(stems, Missing::Guessed));
    return sketch;
}

} // namespace tractus::lines
