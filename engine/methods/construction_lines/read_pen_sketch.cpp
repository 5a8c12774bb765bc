#include "engine/methods/construction_lines/read_pen_sketch.h"

#include <algorithm>
#include <utility>

namespace tractus::lines {

namespace {

// Returns the organs of the layer above an inclination line.
LayerOrgans organs_above(PenSketch const& sketch, SketchLine const& line)
{
    return { .pattern = line.pattern,
             .organ = organ_number(sketch, line.organ.value_or(sketch.organ)) };
}

void add_layers(StemLines& stem, std::vector<std::size_t> const& strokes, PenSketch const& sketch,
                std::size_t number)
{
    auto& nodes = stem.sketch.nodes_above;
    auto& organs = stem.sketch.organs_above;
    nodes.clear();
    organs.clear();
    for (auto const stroke : strokes) {
        nodes.push_back(sketch.lines[stroke].nodes);
        organs.push_back(organs_above(sketch, sketch.lines[stroke]));
    }
    if (strokes.size() >= 2)
        return;
    nodes = { 0 };
    organs = { {} };
    for (auto const& line : sketch.lines)
        if (line.role == Role::Stem && line.stem == number) {
            nodes = { line.nodes };
            organs = { organs_above(sketch, line) };
            return;
        }
}

Result<PenReading> read_one_by_one(PenSketch const& sketch)
{
    StemRecogniser recogniser;
    for (auto const& line : sketch.lines)
        recogniser.add_known(
            TRY(points_on_sheet(line)),
            { .line = { .role = line.role }, .stem = line.stem, .parent = line.parent });
    PenReading reading { .stems = recogniser.stems(),
                         .inclination_strokes = {},
                         .strokes = {},
                         .second_best_roles = {} };
    for (std::size_t i = 0; i < reading.stems.size(); ++i)
        reading.inclination_strokes.push_back(recogniser.inclination_strokes(i));
    return reading;
}

// The strokes of a stem, with their indices among the sketch's lines (`numbers`).
struct StrokesOfStem {
    std::vector<StrokeToExplain> strokes;
    std::vector<std::size_t> numbers;
    std::optional<std::size_t> parent;
};

// Groups the strokes of a sketch by stem. The first stem is found among its strokes unless the user
// has assigned its role; further stems are always assigned by the user.
Result<std::vector<StrokesOfStem>> strokes_of_stems(PenSketch const& sketch)
{
    std::vector<StrokesOfStem> stems;
    for (std::size_t i = 0; i < sketch.lines.size(); ++i) {
        auto const& line = sketch.lines[i];
        if (line.stem >= stems.size())
            stems.resize(line.stem + 1);
        auto& stem = stems[line.stem];
        StrokeToExplain stroke { .points = TRY(points_on_sheet(line)),
                                 .is_clean = true,
                                 .turn_round = line.turn_round };
        if (line.is_assigned || line.role == Role::Around)
            stroke.assigned = line.role;
        if (line.parent)
            stem.parent = line.parent;
        stem.strokes.push_back(std::move(stroke));
        stem.numbers.push_back(i);
    }
    return stems;
}

Result<PenReading> read_together(PenSketch const& sketch)
{
    PenReading reading { .stems = {},
                         .inclination_strokes = {},
                         .strokes = std::vector<ExplainedStroke>(sketch.lines.size()),
                         .second_best_roles = {} };
    for (auto const& [strokes, numbers, parent] : TRY(strokes_of_stems(sketch))) {
        auto& stem = reading.stems.emplace_back();
        stem.parent = parent;
        auto& inclinations = reading.inclination_strokes.emplace_back();
        if (strokes.empty())
            continue;
        auto explanations = explain_sketch(strokes);
        auto& best = explanations.front();
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            auto& stroke = best.strokes[i];
            if (stroke.of)
                stroke.of = numbers[*stroke.of];
            reading.strokes[numbers[i]] = stroke;
        }
        for (auto const stroke : best.inclination_strokes)
            inclinations.push_back(numbers[stroke]);
        stem.sketch = std::move(best.sketch);
        bool const is_newest = numbers.back() + 1 == sketch.lines.size();
        if (!is_newest || explanations.size() < 2)
            continue;
        for (auto const& line : sketch.lines)
            reading.second_best_roles.push_back(line.role);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            reading.second_best_roles[numbers[i]] = explanations[1].strokes[i].role;
    }
    return reading;
}

} // namespace

bool is_read_together(PenSketch const& sketch)
{
    return !sketch.lines.empty()
        && std::all_of(sketch.lines.begin(), sketch.lines.end(),
                       [](SketchLine const& line) { return line.reading == Reading::Together; });
}

Result<PenReading> read_pen_sketch(PenSketch const& sketch)
{
    auto reading = TRY(is_read_together(sketch) ? read_together(sketch) : read_one_by_one(sketch));
    for (std::size_t i = 0; i < reading.stems.size(); ++i)
        add_layers(reading.stems[i], reading.inclination_strokes[i], sketch, i);
    return reading;
}

Result<PenSketch> with_roles_read(PenSketch sketch)
{
    if (!is_read_together(sketch))
        return sketch;
    auto const reading = TRY(read_pen_sketch(sketch));
    for (std::size_t i = 0; i < sketch.lines.size(); ++i)
        sketch.lines[i].role = reading.strokes[i].role;
    return sketch;
}

Result<PenSketch> without_replaced(PenSketch sketch)
{
    if (!is_read_together(sketch))
        return sketch;
    auto const reading = TRY(read_pen_sketch(sketch));
    auto const newest = sketch.lines.size() - 1;
    auto const& line = reading.strokes[newest];
    if (!line.of)
        return sketch;
    auto const& earlier = sketch.lines[*line.of];
    sketch.lines[newest].nodes = earlier.nodes;
    sketch.lines[newest].pattern = earlier.pattern;
    sketch.lines[newest].organ = earlier.organ;
    for (std::size_t i = newest; i-- > 0;) {
        auto const& each = reading.strokes[i];
        bool const is_same_line = i == *line.of || each.of == line.of;
        if (is_same_line && each.is_replaced) {
            if (sketch.lines[i].parent)
                sketch.lines.back().parent = sketch.lines[i].parent;
            sketch.lines.erase(sketch.lines.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    return sketch;
}

} // namespace tractus::lines
