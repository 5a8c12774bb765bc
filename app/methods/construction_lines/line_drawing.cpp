#include "app/methods/construction_lines/line_drawing.h"

#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "engine/stroke/polyline.h"

#include <cstddef>
#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

namespace {

// A line as a pen's stroke. One without two points is left for the sketch to be refused.
std::vector<Vec3> captured(std::vector<Vec3> const& tips)
{
    auto const points = distinct_points(tips);
    return points ? capture_line(*points) : tips;
}

std::vector<Vec2> captured(std::vector<Vec2> const& tips)
{
    std::vector<Vec3> points;
    for (auto const& tip : tips)
        points.emplace_back(tip.x(), tip.y(), 0);
    std::vector<Vec2> line;
    for (auto const& point : captured(points))
        line.push_back(point.head<2>());
    return line;
}

void capture_lines(LineSketch& sketch)
{
    sketch.stem = captured(sketch.stem);
    sketch.left = captured(sketch.left);
    sketch.right = captured(sketch.right);
    for (auto& line : sketch.inclinations)
        line = captured(line);
}

std::string note_of(RecognisedLine const& line, std::size_t number)
{
    if (line.role == Role::Unsure)
        return fmt::format("stroke {} is left out: {}", number, line.reason);
    return fmt::format("stroke {} is drawn in place of stroke {}: {}", number, *line.replaces + 1,
                       name_of(line.role));
}

Result<LineDrawing> recognise_strokes(LineSketchFile const& file, Smoothing smoothing)
{
    std::size_t point_count = 0;
    for (auto const& stroke : file.strokes)
        point_count += stroke.size();
    TRY(check_point_count(point_count));
    LineRecogniser recogniser;
    LineDrawing drawing { .sketch = {}, .roles = {}, .notes = {} };
    for (auto const& stroke : file.strokes) {
        auto const number = drawing.roles.size() + 1;
        auto points = without_repeats(stroke);
        if (points.size() < 2)
            return fail(Fault::User, fmt::format("stroke {} is only a dot: leave it out", number));
        if (smoothing == Smoothing::Hand)
            points = without_repeats(capture_line(points));
        auto const& line = recogniser.add(points);
        drawing.roles.push_back(name_of(line.role));
        if (line.role == Role::Unsure || line.replaces)
            drawing.notes.push_back(note_of(line, number));
    }
    drawing.sketch = recogniser.sketch();
    drawing.sketch.nodes_per_layer = file.sketch.nodes_per_layer;
    return drawing;
}

} // namespace

Result<LineDrawing> prepare_drawing(LineSketchFile const& file, Smoothing smoothing)
{
    if (!file.strokes.empty())
        return recognise_strokes(file, smoothing);
    LineDrawing drawing { .sketch = file.sketch, .roles = {}, .notes = {} };
    if (smoothing == Smoothing::Hand)
        capture_lines(drawing.sketch);
    return drawing;
}

} // namespace tractus::lines
