#include "engine/methods/construction_lines/pen_sketch.h"

#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/varied_sketch.h"
#include "engine/scene/lsystem_source.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/upright_sheet.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace tractus::lines {

using tractus::name_of; // Of items.

namespace {

constexpr double kModelScale = 0.1; // Of a model's text: a millimetre drawn is a centimetre grown.

Result<LineRecogniser> recogniser_of(PenSketch const& sketch)
{
    LineRecogniser recogniser;
    for (auto const& line : sketch.lines)
        recogniser.add_known(TRY(points_on_sheet(line)), line.role);
    return recogniser;
}

LineSketch sketch_of(LineRecogniser const& recogniser, PenSketch const& sketch)
{
    auto result = recogniser.sketch();
    auto const strokes = recogniser.inclination_strokes();
    for (auto const stroke : strokes)
        result.nodes_above.push_back(sketch.lines[stroke].nodes);
    if (strokes.size() < 2) {
        result.nodes_above = { 0 };
        for (auto const& line : sketch.lines)
            if (line.role == Role::Stem)
                result.nodes_above = { line.nodes };
    }
    return result;
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
}

Result<void> check_stem(LineSketch const& sketch)
{
    constexpr double kShortest_mm = 10; // On the tablet, where a touch is not meant as a plant.
    if (sketch.stem.empty())
        return fail(Fault::User,
                    "the sketch would have no stem: say first which of its lines is the stem");
    auto const length_mm = polyline_length_mm(sketch.stem);
    if (length_mm < kShortest_mm)
        return fail(
            Fault::User,
            fmt::format("the stem is only {:.0f} mm long: draw at least {:.0f} mm, from the "
                        "plant's foot to its top",
                        length_mm, kShortest_mm));
    return {};
}

// A sketch that gives a plant.
Result<PenSketch> checked(PenSketch sketch)
{
    auto const lines = TRY(line_sketch(sketch));
    TRY(check_stem(lines));
    TRY(measure_sketch(lines, Missing::Guessed));
    return sketch;
}

Result<void> check_line(PenSketch const& sketch, ItemId line)
{
    if (find_line(sketch, line))
        return {};
    return fail(Fault::User,
                fmt::format("the sketch has no line {}: it was drawn again, or is "
                            "another plant's",
                            name_of(line)));
}

bool same(SketchLine const& one, SketchLine const& other)
{
    return one.id == other.id && one.stroke.tips.id() == other.stroke.tips.id()
        && one.sheet.offset_mm == other.sheet.offset_mm && one.sheet.size == other.sheet.size
        && one.role == other.role && one.nodes == other.nodes;
}

bool same(PenSketch const& one, PenSketch const& other)
{
    return one.pattern.kind == other.pattern.kind
        && one.pattern.divergence_deg == other.pattern.divergence_deg
        && one.pattern.whorl == other.pattern.whorl && one.scale == other.scale
        && std::equal(one.lines.begin(), one.lines.end(), other.lines.begin(), other.lines.end(),
                      [](SketchLine const& line, SketchLine const& another) {
                          return same(line, another);
                      });
}

// What a model's measured stem alone has.
Pattern pattern_of(PenSketch const& sketch, LineSketch const& lines)
{
    auto pattern = sketch.pattern;
    if (!has_boundary(lines))
        pattern.kind = Pattern::Kind::Bare;
    return pattern;
}

} // namespace

constexpr SourceKind kPenSketch {
    .word = "construction_lines",
    .build =
        [](void const* drawn, LoadOptions const& options) {
            return build_pen_sketch(*static_cast<PenSketch const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<PenSketch const*>(one), *static_cast<PenSketch const*>(other));
        },
    .model = [](void const* drawn) -> Result<SourceModel> {
        auto model = TRY(model_of(*static_cast<PenSketch const*>(drawn)));
        return SourceModel { std::move(model.source), std::move(model.functions) };
    },
    .vary = [](void const* drawn, SourceVariation const& variation) -> std::shared_ptr<void const> {
        return std::make_shared<PenSketch const>(
            varied_sketch(*static_cast<PenSketch const*>(drawn), variation));
    },
};

Result<std::vector<Vec3>> points_on_sheet(SketchLine const& line)
{
    auto const dot
        = [] { return fail(Fault::User, "this is only a dot: draw a line of the sketch"); };
    auto const tips = TRY(line.stroke.tips.in_memory());
    bool const is_flat = decide_surface(tips, StrokeSurface::Decided) == StrokeSurface::Paper;
    std::vector<Vec3> places;
    for (auto const& tip_mm : plant_tips(tips, StrokeSurface::Paper)) {
        auto const place_mm = line.sheet.on_sheet({ tip_mm.x(), tip_mm.z() });
        places.emplace_back(place_mm.x(), place_mm.y(),
                            is_flat ? 0 : -line.sheet.size * tip_mm.y());
    }
    auto const drawn = distinct_points(without_repeats(places));
    if (!drawn)
        return dot();
    auto points = without_repeats(capture_line(*drawn));
    if (points.size() < 2)
        return dot();
    return points;
}

Result<PenSketch> with_line(PenSketch sketch, SketchLine line)
{
    constexpr std::size_t kMostLines = 100;
    if (sketch.lines.size() >= kMostLines)
        return fail(Fault::User,
                    fmt::format("the sketch has {} lines already: begin another stem", kMostLines));
    auto recogniser = TRY(recogniser_of(sketch));
    auto const& known = recogniser.add(TRY(points_on_sheet(line)));
    line.role = known.role;
    if (known.replaces) {
        line.nodes = sketch.lines[*known.replaces].nodes;
        sketch.lines.erase(sketch.lines.begin() + static_cast<std::ptrdiff_t>(*known.replaces));
    }
    sketch.lines.push_back(std::move(line));
    return checked(std::move(sketch));
}

Result<PenSketch> with_role(PenSketch sketch, ItemId line, Role role)
{
    TRY(check_line(sketch, line));
    bool const is_one = role == Role::Stem || role == Role::Left || role == Role::Right;
    for (auto& other : sketch.lines) {
        if (is_one && other.role == role)
            other.role = Role::Unsure;
        if (other.id == line)
            other.role = role;
    }
    return checked(std::move(sketch));
}

Result<PenSketch> with_other_stroke(PenSketch sketch, ItemId line, Stroke stroke)
{
    TRY(check_line(sketch, line));
    auto const found = std::find_if(sketch.lines.begin(), sketch.lines.end(),
                                    [&](SketchLine const& each) { return each.id == line; });
    found->stroke = std::move(stroke);
    return checked(std::move(sketch));
}

Result<LineSketch> line_sketch(PenSketch const& sketch, Unit unit)
{
    auto result = sketch_of(TRY(recogniser_of(sketch)), sketch);
    if (unit == Unit::Plant && sketch.scale != kModelScale)
        scale_lines(result, kModelScale / sketch.scale);
    return result;
}

Result<LineModel> model_of(PenSketch const& sketch)
{
    auto const lines = TRY(line_sketch(sketch, Unit::Plant));
    auto const construction = TRY(measure_sketch(lines, Missing::Guessed));
    return write_model(construction, pattern_of(sketch, lines), "lines");
}

Result<BuiltSource> build_pen_sketch(PenSketch const& sketch, LoadOptions const& options)
{
    auto model = TRY(model_of(sketch));
    return build_lsystem(
        { .source = std::move(model.source), .includes = std::move(model.functions) }, options);
}

Result<std::vector<Layer>> layers_of(PenSketch const& sketch)
{
    auto const recogniser = TRY(recogniser_of(sketch));
    auto const lines = sketch_of(recogniser, sketch);
    auto const construction = TRY(measure_sketch(lines, Missing::Guessed));
    auto const strokes = recogniser.inclination_strokes();
    auto const stem = std::find_if(sketch.lines.begin(), sketch.lines.end(),
                                   [](SketchLine const& line) { return line.role == Role::Stem; });
    std::vector<Layer> layers;
    for (std::size_t i = 0; i + 1 < construction.inclinations.size(); ++i) {
        auto const& below = construction.inclinations[i];
        auto const& line = strokes.size() < 2 ? *stem : sketch.lines[strokes[below.drawn]];
        layers.push_back({ line.id, below.x, construction.inclinations[i + 1].x, line.nodes });
    }
    return layers;
}

Result<Layer> layer_at(PenSketch const& sketch, Vec2 const& place_mm)
{
    DrawnStem const stem(TRY(line_sketch(sketch)).stem);
    auto const layers = TRY(layers_of(sketch));
    double const x = stem.place(stem.seen().nearest_mm(place_mm));
    auto const above = std::find_if(layers.begin(), layers.end(),
                                    [&](Layer const& layer) { return x < layer.to_x; });
    return above == layers.end() ? layers.back() : *above;
}

std::optional<ItemId> line_at(PenSketch const& sketch, Vec2 const& place_mm)
{
    constexpr double kFinger_mm = 15;
    double nearest_mm = kFinger_mm;
    std::optional<ItemId> found;
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

SketchLine const* find_line(PenSketch const& sketch, ItemId line)
{
    auto const found = std::find_if(sketch.lines.begin(), sketch.lines.end(),
                                    [&](SketchLine const& each) { return each.id == line; });
    return found == sketch.lines.end() ? nullptr : &*found;
}

} // namespace tractus::lines
