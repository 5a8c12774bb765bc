#include "app/methods/construction_lines/line_drawing.h"

#include "app/methods/construction_lines/organ_library.h"
#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/recognise_stems.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <memory>
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

LineSketch captured(LineSketch sketch)
{
    sketch.stem = captured(sketch.stem);
    sketch.left = captured(sketch.left);
    sketch.right = captured(sketch.right);
    for (auto& line : sketch.inclinations)
        line = captured(line);
    for (auto& line : sketch.around)
        line = captured(line);
    return sketch;
}

// Another stem, on the one on which it begins, if it does.
void add_stem(std::vector<StemLines>& stems, LineSketch sketch)
{
    auto const parent
        = sketch.stem.empty() ? std::nullopt : parent_at(stems, sketch.stem.front().head<2>());
    stems.push_back({ .sketch = std::move(sketch), .parent = parent });
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
    StemRecogniser recogniser;
    LineDrawing drawing;
    std::vector<Vec3> stem_before; // With whose length the next strokes' depths are compared.
    std::vector<std::vector<int>> nodes_of_stems { file.sketch.nodes_per_layer };
    for (auto const& stroke : file.strokes) {
        auto const number = drawing.roles.size() + 1;
        auto points = without_repeats(stroke);
        if (points.size() < 2)
            return fail(Fault::User, fmt::format("stroke {} is only a dot: leave it out", number));
        if (smoothing == Smoothing::Hand)
            points = without_repeats(capture_line(points));
        auto const stem = file.stem_strokes.find(number - 1);
        auto says = StemRecogniser::Says::Nothing;
        if (stem != file.stem_strokes.end())
            says = StemRecogniser::Says::AnotherStem;
        else if (depth_of(points, stem_before) > kFlat)
            says = StemRecogniser::Says::InSpace;
        auto const& known = recogniser.add(points, says);
        if (known.line.role == Role::Stem)
            stem_before = points;
        if (stem != file.stem_strokes.end()) {
            nodes_of_stems.resize(known.stem + 1);
            nodes_of_stems[known.stem] = stem->second;
        }
        drawing.roles.push_back(name_of(known.line.role));
        drawing.stems_of_strokes.push_back(known.stem);
        if (known.line.role == Role::Unsure || known.line.replaces)
            drawing.notes.push_back(note_of(known.line, number));
    }
    drawing.stems = recogniser.stems();
    for (std::size_t i = 0; i < drawing.stems.size(); ++i) {
        drawing.stems[i].sketch.nodes_per_layer = nodes_of_stems[i];
        drawing.stems[i].sketch.organs_per_layer = file.layers;
    }
    return drawing;
}

namespace fs = std::filesystem;

// Reads sketches that are organs of others.
class Composer {
public:
    Composer(Smoothing smoothing, std::vector<std::string>& notes)
        : smoothing_(smoothing)
        , notes_(notes)
    {
    }

    Result<ComposedSketch> compose(fs::path const& path, LineSketchFile const& file,
                                   std::vector<MeasuredStem> const& stems);

private:
    Result<ComposedSketch> load_sketch(fs::path const& path);

    Smoothing smoothing_;
    std::vector<std::string>& notes_;
    std::vector<fs::path> chain_ {}; // From the first sketch to the one that is read.
};

Result<OrganSurface> surface_of(OrganSource const& organ, fs::path const& folder)
{
    if (organ.file.empty())
        return organ.surface;
    return surface_of(TRY(load_named_organ(organ.file, folder)));
}

Result<ComposedSketch> Composer::load_sketch(fs::path const& path)
{
    constexpr std::size_t kDeepest = 5;
    auto const about = [&](Error const& error) {
        return fail(error.fault, fmt::format("{}: {}", path.string(), error.message));
    };
    if (std::find(chain_.begin(), chain_.end(), path) != chain_.end() || chain_.size() >= kDeepest)
        return about({ Fault::User,
                       "it is an organ of itself, or of an organ of an organ and so on: "
                       "leave it out" });
    auto const file = TRY(load_line_sketch(path));
    auto const drawing = prepare_drawing(file, smoothing_);
    if (!drawing)
        return about(drawing.error());
    auto const stems = measure_stems(drawing->stems);
    if (!stems)
        return about(stems.error());
    if (stems->size() > 1)
        return about(
            { Fault::User, "a sketch that is an organ has one stem: leave the others out" });
    for (auto const& found : { drawing->notes, notes_of(*stems) })
        for (auto const& note : found)
            notes_.push_back(fmt::format("{}: {}", path.string(), note));
    return compose(path, file, *stems);
}

Result<ComposedSketch> Composer::compose(fs::path const& path, LineSketchFile const& file,
                                         std::vector<MeasuredStem> const& stems)
{
    chain_.push_back(path);
    auto const folder = path.parent_path();
    auto leaf = TRY(surface_of(file.organ, folder));
    ComposedSketch sketch { .stems = stems, .pattern = file.pattern, .leaf = std::move(leaf) };
    for (auto const& organ : file.organs) {
        LineOrgan loaded;
        if (organ.file.empty() || names_organ(organ.file, folder)) {
            loaded.surface = TRY(surface_of(organ, folder));
        } else {
            auto const other = (folder / organ.file).lexically_normal();
            loaded.sketch = std::make_shared<ComposedSketch const>(TRY(load_sketch(other)));
        }
        sketch.organs.push_back(std::move(loaded));
    }
    chain_.pop_back();
    return sketch;
}

} // namespace

Result<ComposedSketch> load_composed(fs::path const& path, LineSketchFile const& file,
                                     std::vector<MeasuredStem> const& stems, Smoothing smoothing,
                                     std::vector<std::string>& notes)
{
    return Composer(smoothing, notes).compose(path.lexically_normal(), file, stems);
}

Result<LineDrawing> prepare_drawing(LineSketchFile const& file, Smoothing smoothing)
{
    if (!file.strokes.empty())
        return recognise_strokes(file, smoothing);
    LineDrawing drawing;
    auto const add = [&](LineSketch const& sketch) {
        add_stem(drawing.stems, smoothing == Smoothing::Hand ? captured(sketch) : sketch);
    };
    add(file.sketch);
    std::for_each(file.more_stems.begin(), file.more_stems.end(), add);
    for (auto& stem : drawing.stems)
        stem.sketch.organs_per_layer = file.layers;
    return drawing;
}

} // namespace tractus::lines
