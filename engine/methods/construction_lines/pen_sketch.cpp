#include "engine/methods/construction_lines/pen_sketch.h"

#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/read_pen_sketch.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace tractus::lines {

using scene::name_of; // Gives the name of an item, for messages.

namespace {

// World millimetres per plant millimetre at which a model's text needs no scaling: a millimetre
// drawn is a centimetre of the plant.
constexpr double kModelScale = 0.1;

Result<StemRecogniser> recogniser_of(PenSketch const& sketch)
{
    StemRecogniser recogniser;
    for (auto const& line : sketch.lines)
        recogniser.add_known(
            TRY(points_on_sheet(line)),
            { .line = { .role = line.role }, .stem = line.stem, .parent = line.parent });
    return recogniser;
}

void scale_lines(LineSketch& sketch, double factor)
{
    for (auto& point : sketch.stem)
        point *= factor;
    auto const scale = [&](std::vector<Vec2>& line) {
        for (auto& point : line)
            point *= factor;
    };
    scale(sketch.left);
    scale(sketch.right);
    std::for_each(sketch.inclinations.begin(), sketch.inclinations.end(), scale);
    for (auto& line : sketch.around)
        for (auto& point : line)
            point *= factor;
}

constexpr char const* kNoStem
    = "the sketch would have no stem: say first which of its lines is the stem";

Result<void> check_stem(LineSketch const& sketch)
{
    // Minimum length of a stem on the tablet; shorter strokes are accidental touches.
    constexpr double kShortest_mm = 10;
    if (sketch.stem.empty())
        return fail(Fault::User, kNoStem);
    auto const length_mm = polyline_length_mm(sketch.stem);
    if (length_mm < kShortest_mm)
        return fail(
            Fault::User,
            fmt::format("the stem is only {:.0f} mm long: draw at least {:.0f} mm, from the "
                        "plant's foot to its top",
                        length_mm, kShortest_mm));
    return {};
}

// Updates the roles of a sketch's lines. Fails with a user error if the sketch gives no plant.
Result<PenSketch> checked(PenSketch sketch)
{
    sketch = TRY(with_roles_read(std::move(sketch)));
    auto const stems = TRY(stem_sketches(sketch));
    for (auto const& stem : stems)
        TRY(check_stem(stem.sketch));
    TRY(measure_stems(stems, Missing::Guessed));
    return sketch;
}

Result<void> check_line(PenSketch const& sketch, scene::ItemId line)
{
    if (find_line(sketch, line))
        return {};
    return fail(Fault::User,
                fmt::format("the sketch has no line {}: it was drawn again, or is "
                            "another plant's",
                            scene::name_of(line)));
}

// Height of the drawing surface at the beginning of a line, in mm.
Result<double> level_of(SketchLine const& line)
{
    auto const tips = TRY(line.stroke.tips.in_memory());
    return tips.empty() ? 0 : tips.front().position_mm.z();
}

// Finds the stem with this number; null if there is none.
SketchLine const* stem_line(PenSketch const& sketch, std::size_t stem)
{
    auto const found
        = std::find_if(sketch.lines.begin(), sketch.lines.end(), [&](SketchLine const& line) {
              return line.role == Role::Stem && line.stem == stem;
          });
    return found == sketch.lines.end() ? nullptr : &*found;
}

SketchLine const* newest_stem(PenSketch const& sketch)
{
    auto const found = std::find_if(sketch.lines.rbegin(), sketch.lines.rend(),
                                    [](SketchLine const& line) { return line.role == Role::Stem; });
    return found == sketch.lines.rend() ? nullptr : &*found;
}

// True if the drawing surface moved far enough, while the line was drawn, for the line to leave the
// sheet of the stem.
Result<bool> leaves_sheet(SketchLine const& line, SketchLine const& stem)
{
    auto const tips = TRY(line.stroke.tips.in_memory());
    auto const [lowest, highest]
        = std::minmax_element(tips.begin(), tips.end(), [](TipSample const& a, TipSample const& b) {
              return a.position_mm.z() < b.position_mm.z();
          });
    if (lowest == tips.end())
        return false;
    double const moved_mm = line.sheet.size * (highest->position_mm.z() - lowest->position_mm.z());
    return moved_mm > kFlat * polyline_length_mm(TRY(points_on_sheet(stem)));
}

// Sets SketchLine::level_mm of all lines in space of a stem to the height at which the stem begins.
// This is also necessary when the stem has been drawn again.
Result<PenSketch> with_levels(PenSketch sketch, std::size_t stem)
{
    auto const* const line = stem_line(sketch, stem);
    if (!line)
        return sketch;
    double const level_mm = TRY(level_of(*line));
    for (auto& other : sketch.lines)
        if (other.role == Role::Stem)
            other.level_mm.reset();
        else if (other.stem == stem && other.level_mm)
            other.level_mm = level_mm;
    return sketch;
}

} // namespace

static Result<PenSketch> with_stroke(PenSketch sketch, SketchLine line, StemRecogniser::Says says)
{
    constexpr std::size_t kMaxLines = 100;
    if (sketch.lines.size() >= kMaxLines)
        return fail(Fault::User,
                    fmt::format("the sketch has {} lines already: begin another stem", kMaxLines));
    auto const* const stem = newest_stem(sketch);
    if (stem && line.depth_by == DepthBy::Height && says == StemRecogniser::Says::Nothing
        && TRY(leaves_sheet(line, *stem))) {
        says = StemRecogniser::Says::InSpace;
        line.level_mm = TRY(level_of(*stem));
    }
    auto recogniser = TRY(recogniser_of(sketch));
    auto const& known = recogniser.add(TRY(points_on_sheet(line)), says);
    line.role = known.line.role;
    line.stem = known.stem;
    line.parent = known.parent;
    // When lines are interpreted together, the role and any replacement follow from the
    // interpretation.
    line.is_assigned = says == StemRecogniser::Says::AnotherStem;
    bool const is_together
        = line.reading == Reading::Together && (sketch.lines.empty() || is_read_together(sketch));
    if (is_together) {
        sketch.lines.push_back(std::move(line));
        sketch = TRY(without_replaced(std::move(sketch)));
        return checked(TRY(with_levels(std::move(sketch), known.stem)));
    }
    if (auto const replaced = known.line.replaces) {
        line.nodes = sketch.lines[*replaced].nodes;
        line.pattern = sketch.lines[*replaced].pattern;
        line.organ = sketch.lines[*replaced].organ;
        sketch.lines.erase(sketch.lines.begin() + static_cast<std::ptrdiff_t>(*replaced));
    }
    sketch.lines.push_back(std::move(line));
    return checked(TRY(with_levels(std::move(sketch), known.stem)));
}

Result<PenSketch> with_line(PenSketch sketch, SketchLine line)
{
    return with_stroke(std::move(sketch), std::move(line), StemRecogniser::Says::Nothing);
}

Result<PenSketch> with_stem(PenSketch sketch, SketchLine line)
{
    return with_stroke(std::move(sketch), std::move(line), StemRecogniser::Says::AnotherStem);
}

Result<PenSketch> with_role(PenSketch sketch, scene::ItemId line, Role role)
{
    TRY(check_line(sketch, line));
    bool const is_one = role == Role::Stem || role == Role::Left || role == Role::Right;
    auto const stem = find_line(sketch, line)->stem;
    auto const stem_lines
        = std::count_if(sketch.lines.begin(), sketch.lines.end(), [&](SketchLine const& each) {
              return each.role == Role::Stem && each.stem == stem;
          });
    if (role != Role::Stem && find_line(sketch, line)->role == Role::Stem && stem_lines == 1)
        return fail(Fault::User, kNoStem);
    std::optional<std::size_t> parent;
    for (auto& other : sketch.lines)
        if (is_one && other.role == role && other.stem == stem) {
            other.role = Role::Unsure;
            // If lines are interpreted together, the role of this line is found anew.
            other.is_assigned = false;
            parent = std::exchange(other.parent, std::nullopt);
        }
    for (auto& other : sketch.lines)
        if (other.id == line) {
            other.role = role;
            other.is_assigned = true;
            other.parent = role == Role::Stem ? parent : std::nullopt;
        }
    return checked(TRY(with_levels(std::move(sketch), stem)));
}

Result<PenSketch> with_other_stroke(PenSketch sketch, scene::ItemId line, Stroke stroke)
{
    TRY(check_line(sketch, line));
    auto const found = std::find_if(sketch.lines.begin(), sketch.lines.end(),
                                    [&](SketchLine const& each) { return each.id == line; });
    found->stroke = std::move(stroke);
    if (!is_read_together(sketch))
        return checked(std::move(sketch));
    // The new stroke also replaces the other pieces of the line.
    auto const number = static_cast<std::size_t>(found - sketch.lines.begin());
    auto const before = TRY(read_pen_sketch(sketch));
    for (std::size_t i = sketch.lines.size(); i-- > 0;)
        if (before.strokes[i].of == number)
            sketch.lines.erase(sketch.lines.begin() + static_cast<std::ptrdiff_t>(i));
    return checked(std::move(sketch));
}

Result<PenSketch> with_line_turned(PenSketch sketch, scene::ItemId line)
{
    TRY(check_line(sketch, line));
    for (auto& other : sketch.lines)
        if (other.id == line)
            other.turn_round = !other.turn_round;
    return checked(std::move(sketch));
}

Result<std::vector<StemLines>> stem_sketches(PenSketch const& sketch, Unit unit)
{
    auto result = TRY(read_pen_sketch(sketch)).stems;
    if (unit == Unit::Plant && sketch.scale != kModelScale)
        for (auto& stem : result)
            scale_lines(stem.sketch, kModelScale / sketch.scale);
    return result;
}

Result<std::size_t> current_stem(PenSketch const& sketch)
{
    auto const sources = function_sources(TRY(stem_sketches(sketch)));
    return sketch.lines.empty() ? 0 : sources.at(sketch.lines.back().stem);
}

PenSketch sketch_of_stem(PenSketch const& sketch, std::size_t stem)
{
    PenSketch alone { .lines = {},
                      .pattern = sketch.pattern,
                      .scale = sketch.scale,
                      .organs = sketch.organs,
                      .organ = sketch.organ };
    for (auto const& line : sketch.lines)
        if (line.stem == stem) {
            alone.lines.push_back(line);
            alone.lines.back().stem = 0;
            alone.lines.back().parent.reset();
        }
    return alone;
}

SketchLine const& first_stem(PenSketch const& sketch)
{
    return *std::find_if(sketch.lines.begin(), sketch.lines.end(), [](SketchLine const& line) {
        return line.role == Role::Stem && line.stem == 0;
    });
}

Result<LineSketch> line_sketch(PenSketch const& sketch)
{
    auto stems = TRY(stem_sketches(sketch));
    return std::move(stems.at(TRY(current_stem(sketch))).sketch);
}

std::size_t organ_number(PenSketch const& sketch, scene::ItemId organ)
{
    auto const found = std::find_if(sketch.organs.begin(), sketch.organs.end(),
                                    [&](SketchOrgan const& each) { return each.id == organ; });
    return found == sketch.organs.end()
        ? 0
        : static_cast<std::size_t>(found - sketch.organs.begin()) + 1;
}

// Returns the layers of a sketch that has a single stem.
static Result<std::vector<Layer>> layers_of_one(PenSketch const& sketch)
{
    auto const reading = TRY(read_pen_sketch(sketch));
    auto const construction = TRY(measure_sketch(reading.stems.front().sketch, Missing::Guessed));
    auto const& strokes = reading.inclination_strokes.front();
    auto const& stem = first_stem(sketch);
    std::vector<Layer> layers;
    for (std::size_t i = 0; i + 1 < construction.inclinations.size(); ++i) {
        auto const& below = construction.inclinations[i];
        auto const& line = strokes.size() < 2 ? stem : sketch.lines[strokes[below.drawn]];
        layers.push_back({ line.id, below.x, construction.inclinations[i + 1].x, line.nodes });
    }
    return layers;
}

Result<std::vector<Layer>> layers_of(PenSketch const& sketch)
{
    return layers_of_one(sketch_of_stem(sketch, TRY(current_stem(sketch))));
}

// Returns the number of the stem nearest to a point on the sheet, among the stems with lines of
// their own.
static std::size_t nearest_stem(std::vector<StemLines> const& stems, Vec2 const& place_mm)
{
    auto const sources = function_sources(stems);
    double min_mm = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < stems.size(); ++i) {
        DrawnStem const stem(stems[i].sketch.stem);
        auto const& seen = stem.seen();
        double const away_mm = (seen.point(seen.nearest_mm(place_mm)) - place_mm).norm();
        if (sources[i] == i && away_mm < min_mm) {
            min_mm = away_mm;
            nearest = i;
        }
    }
    return nearest;
}

Result<Layer> layer_at(PenSketch const& sketch, Vec2 const& place_mm)
{
    auto const stems = TRY(stem_sketches(sketch));
    auto const nearest = nearest_stem(stems, place_mm);
    DrawnStem const stem(stems[nearest].sketch.stem);
    auto const layers = TRY(layers_of_one(sketch_of_stem(sketch, nearest)));
    double const x = stem.place(stem.seen().nearest_mm(place_mm));
    auto const above = std::find_if(layers.begin(), layers.end(),
                                    [&](Layer const& layer) { return x < layer.to_x; });
    return above == layers.end() ? layers.back() : *above;
}

std::optional<scene::ItemId> line_at(PenSketch const& sketch, Vec2 const& place_mm)
{
    constexpr double kFinger_mm = 15;
    double nearest_mm = kFinger_mm;
    std::optional<scene::ItemId> found;
    for (auto const& line : sketch.lines) {
        auto const points = points_on_sheet(line);
        if (!points)
            continue;
        std::vector<Vec2> flat;
        for (auto const& point : *points)
            flat.emplace_back(point.x(), point.y());
        DrawnLine const drawn(std::move(flat));
        double const distance_mm = (drawn.point(drawn.nearest_mm(place_mm)) - place_mm).norm();
        if (distance_mm < nearest_mm) {
            nearest_mm = distance_mm;
            found = line.id;
        }
    }
    return found;
}

SketchLine const* find_line(PenSketch const& sketch, scene::ItemId line)
{
    auto const found = std::find_if(sketch.lines.begin(), sketch.lines.end(),
                                    [&](SketchLine const& each) { return each.id == line; });
    return found == sketch.lines.end() ? nullptr : &*found;
}

} // namespace tractus::lines
