#include "engine/methods/leaves/leaf_sketch.h"

#include "engine/base/random.h"
#include "engine/methods/leaves/print_grammar.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace tractus::leaf {

namespace {

using Points = std::vector<Vec3>;

constexpr std::size_t kMaxLines = 200;

Result<void> check_number(double value, double least, double greatest, char const* what)
{
    if (value >= least && value <= greatest)
        return {};
    return fail(
        Fault::User,
        fmt::format("a leaf's {} cannot be {:g}: give {:g} to {:g}", what, value, least, greatest));
}

// True for a line that ends near its beginning.
bool is_closed(Points const& line)
{
    // Largest gap between the ends of a closed line, as a share of the line's length.
    constexpr double kWidestGap = 0.15;
    return (line.back() - line.front()).norm() < kWidestGap * polyline_length_mm(line);
}

// Distance from a point to a polyline.
double distance_to(Points const& line, Vec3 const& place)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        double const share = nearest_share<Vec3>(place, line[i - 1], line[i]);
        least = std::min(least,
                         (place - line[i - 1] - share * (line[i] - line[i - 1])).squaredNorm());
    }
    return std::sqrt(least);
}

double mean_distance(Points const& from, Points const& to)
{
    double sum = 0;
    for (auto const& place : from)
        sum += distance_to(to, place);
    return sum / static_cast<double>(from.size());
}

// Makes the depths of a line relative to its first point, because a line may be redrawn at another
// height of the surface, and reduces the number of its points.
Points from_its_begin(Points const& line)
{
    constexpr std::size_t kMaxPoints = 500;
    std::size_t const count = std::min(line.size(), kMaxPoints);
    Points made;
    for (std::size_t i = 0; i < count; ++i) {
        made.push_back(line[i * (line.size() - 1) / (count - 1)]);
        made.back().z() -= line.front().z();
    }
    return made;
}

// True if the centre of one of two closed lines is inside the other line.
bool lie_on_each_other(Points const& line, Points const& other)
{
    auto const flat = [](Points const& of) {
        FlatLine made;
        for (auto const& point : of)
            made.emplace_back(point.head<2>());
        return made;
    };
    auto const middle_of = [](FlatLine const& ring) {
        Eigen::AlignedBox2d box;
        for (auto const& place : ring)
            box.extend(place);
        return Vec2(box.center());
    };
    auto const one = flat(line);
    auto const two = flat(other);
    return is_inside(two, middle_of(one)) || is_inside(one, middle_of(two));
}

// True if one line traces the other along its whole length, in either direction, or if they are
// closed lines of which one contains the other's centre.
bool draws_again(Points const& line, Points const& other)
{
    constexpr double kNear_mm = 2.5;
    constexpr double kEndsNear_mm = 5;
    if (is_closed(line) || is_closed(other))
        return is_closed(line) && is_closed(other) && lie_on_each_other(line, other);
    auto const end_to_end = [&](Vec3 const& first, Vec3 const& last) {
        return std::max((line.front() - first).norm(), (line.back() - last).norm());
    };
    double const ends_mm = std::min(end_to_end(other.front(), other.back()),
                                    end_to_end(other.back(), other.front()));
    return ends_mm <= kEndsNear_mm && mean_distance(line, other) <= kNear_mm
        && mean_distance(other, line) <= kNear_mm;
}

// Guesses a midrib if the longest line is closed, or is the only line. Otherwise returns no value.
std::optional<Points> guessed_midrib(LeafDrawing const& drawing)
{
    constexpr int kPieces = 32;
    auto const& line = *std::ranges::max_element(
        drawing.strokes, {}, [](Points const& each) { return polyline_length_mm(each); });
    if (!is_closed(line) && drawing.strokes.size() > 1)
        return std::nullopt;
    Vec3 const base = line.front();
    auto const far = [&](Vec3 const& place) { return (place - base).norm(); };
    Vec3 const tip = is_closed(line) ? *std::ranges::max_element(line, {}, far) : line.back();
    Points midrib;
    for (int i = 0; i <= kPieces; ++i)
        midrib.emplace_back(base + (tip - base) * i / kPieces);
    return midrib;
}

Result<LeafRecognition> seen_with_midrib(LeafDrawing const& drawing)
{
    auto lines = TRY(recognise_leaf(drawing));
    auto fit = TRY(fit_leaf(lines));
    return LeafRecognition { .lines = std::move(lines), .fit = std::move(fit) };
}

Result<LeafRecognition> seen_in(LeafDrawing drawing)
{
    auto seen = seen_with_midrib(drawing);
    auto midrib = seen ? std::nullopt : guessed_midrib(drawing);
    if (!midrib)
        return seen;
    drawing.strokes.push_back(*std::move(midrib));
    auto guessed = seen_with_midrib(drawing);
    if (!guessed)
        return seen;
    guessed->is_midrib_guessed = true;
    return guessed;
}

// Tries to recognise the drawing without one of its newest lines, beginning with the newest, which
// is most likely wrong. `why` is the reason why the whole drawing is no leaf.
std::optional<LeafRecognition> seen_without_one(LeafDrawing const& drawing, std::string const& why)
{
    constexpr std::size_t kNewest = 4;
    auto const lines = drawing.strokes.size();
    for (std::size_t i = lines; i-- > 0 && i + kNewest >= lines && lines > 1;) {
        auto fewer = drawing;
        auto const at = static_cast<std::ptrdiff_t>(i);
        fewer.strokes.erase(fewer.strokes.begin() + at);
        auto seen = seen_in(std::move(fewer));
        if (!seen)
            continue;
        auto& roles = seen->lines.roles;
        roles.insert(roles.begin() + at, StrokeRole::FinerVein);
        seen->left_out = why;
        return *std::move(seen);
    }
    return std::nullopt;
}

LeafSketch looked_at(LeafSketch sketch)
{
    auto seen = recognise_leaf_sketch(sketch);
    sketch.seen = seen ? std::make_shared<LeafRecognition const>(*std::move(seen)) : nullptr;
    return sketch;
}

bool same_lines(LeafSketch const& one, LeafSketch const& other)
{
    return std::ranges::equal(one.lines, other.lines, [](LeafLine const& a, LeafLine const& b) {
        return a.id == b.id && a.stroke.tips.id() == b.stroke.tips.id();
    });
}

bool same(LeafSketch const& one, LeafSketch const& other)
{
    return same_lines(one, other) && one.form == other.form && one.scale == other.scale
        && one.seed == other.seed && one.spread == other.spread;
}

LeafSketch varied(LeafSketch sketch, scene::SourceVariation const& variation)
{
    constexpr std::uint32_t kStream = 0x6c66;
    Random random({ variation.seed, kStream + variation.stream, variation.plant });
    sketch.seed = random.next_u64();
    sketch.spread = variation.spread;
    return sketch;
}

} // namespace

Result<void> check_form(LeafForm const& form)
{
    TRY(check_number(form.bend_deg, -180, 180, "bend"));
    TRY(check_number(form.rise_deg, -90, 90, "rise"));
    TRY(check_number(form.vein_curve_deg, -90, 90, "veins' curve"));
    TRY(check_number(form.vein_width, 0.2, 5, "veins' width"));
    TRY(check_number(form.teeth, 0, 60, "number of teeth"));
    TRY(check_number(form.tooth_depth, 0, 0.2, "teeth's depth"));
    return check_number(form.variation, 0, 4, "variation");
}

Result<LeafDrawing> drawing_of(LeafSketch const& sketch)
{
    LeafDrawing drawing;
    double begins_mm = 0;
    drawing.may_be_compound = std::ranges::all_of(
        sketch.lines, [](LeafLine const& line) { return line.may_be_leaflet; });
    for (auto const& line : sketch.lines) {
        auto const tips = TRY(line.stroke.tips.in_memory());
        auto points = TRY(stroke_points({ tips }));
        if (drawing.strokes.empty())
            begins_mm = points.front().z();
        for (auto& point : points)
            point.z() -= begins_mm;
        drawing.strokes.push_back(std::move(points));
    }
    return drawing;
}

Result<Vec2> foot_of(LeafSketch const& sketch)
{
    auto const drawing = TRY(drawing_of(sketch));
    Vec2 lowest = drawing.strokes.front().front().head<2>();
    for (auto const& stroke : drawing.strokes)
        for (auto const& point : stroke)
            if (point.y() < lowest.y())
                lowest = point.head<2>();
    return lowest;
}

Result<LeafRecognition> recognise_leaf_sketch(LeafSketch const& sketch)
{
    auto const drawing = TRY(drawing_of(sketch));
    auto seen = seen_in(drawing);
    if (!seen)
        if (auto without = seen_without_one(drawing, seen.error().message))
            return *std::move(without);
    return seen;
}

Result<LeafSketch> with_line(LeafSketch sketch, LeafLine line)
{
    auto const drawn = drawing_of({ .lines = { line } });
    if (!drawn)
        return fail(Fault::User,
                    "a dot is no line of a leaf: draw its outline, its midrib or a vein");
    auto const before = TRY(drawing_of(sketch));
    auto const again = std::ranges::find_if(before.strokes, [&](Points const& other) {
        return draws_again(from_its_begin(drawn->strokes.front()), from_its_begin(other));
    });
    if (again != before.strokes.end())
        sketch.lines[static_cast<std::size_t>(again - before.strokes.begin())] = std::move(line);
    else
        sketch.lines.push_back(std::move(line));
    if (sketch.lines.size() > kMaxLines)
        return fail(Fault::User,
                    fmt::format("a leaf has at most {} lines: begin another leaf", kMaxLines));
    return looked_at(std::move(sketch));
}

Result<LeafSketch> without_line(LeafSketch sketch, scene::ItemId line)
{
    auto const removed
        = std::erase_if(sketch.lines, [&](LeafLine const& each) { return each.id == line; });
    if (removed == 0)
        return fail(Fault::User, "the leaf has no such line any more");
    if (sketch.lines.empty())
        return fail(Fault::User,
                    "nothing of the leaf would be left: remove the plant to take it away");
    return looked_at(std::move(sketch));
}

std::optional<DrawnLeaf> adjusted_leaf(LeafSketch const& sketch)
{
    if (!sketch.seen)
        return std::nullopt;
    auto leaf = sketch.seen->fit.leaf;
    auto const& form = sketch.form;
    leaf.bend_deg += form.bend_deg;
    leaf.rise_deg = std::clamp(leaf.rise_deg + form.rise_deg, -85.0, 85.0);
    leaf.side_curve_deg += form.vein_curve_deg;
    leaf.side_curve_at_tip_deg += form.vein_curve_deg;
    leaf.width *= form.vein_width;
    leaf.spread_deg *= form.variation;
    if (form.teeth > 0) {
        leaf.margin = HalfOutline::Margin::Teeth;
        leaf.tooth_count = form.teeth;
        leaf.tooth_depth = form.tooth_depth;
        leaf.tooth_lean = 0.4;
    }
    return leaf;
}

Result<std::string> grammar_text(LeafSketch const& sketch, std::string const& title)
{
    auto const leaf = adjusted_leaf(sketch);
    if (leaf)
        return print_grammar(*leaf, title);
    TRY(recognise_leaf_sketch(sketch)); // The call fails, with a message about what is missing.
    return fail(Fault::User, "the lines are no leaf yet");
}

constexpr scene::SourceKind LeafSketch::kKind {
    .word = "leaf_sketch",
    .build =
        [](void const* drawn, scene::LoadOptions const& options) {
            return build_leaf(*static_cast<LeafSketch const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<LeafSketch const*>(one),
                        *static_cast<LeafSketch const*>(other));
        },
    .vary = [](void const* drawn,
               scene::SourceVariation const& variation) -> std::shared_ptr<void const> {
        return std::make_shared<LeafSketch const>(
            varied(*static_cast<LeafSketch const*>(drawn), variation));
    },
};

} // namespace tractus::leaf
