#include "app/methods/construction_lines/line_drawing.h"

#include "app/methods/construction_lines/organ_library.h"
#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/recognise_stems.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace tractus::lines {

namespace {

// Smooths a line like a stroke of a pen. A line with fewer than two distinct points is returned
// unchanged; reading the sketch fails later.
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

// Adds another stem. Its parent is the earlier stem on which it begins, if any.
void add_stem(std::vector<StemLines>& stems, LineSketch sketch)
{
    auto const parent
        = sketch.stem.empty() ? std::nullopt : parent_at(stems, sketch.stem.front().head<2>());
    stems.push_back({ .sketch = std::move(sketch), .parent = parent });
}

// Reads the strokes of a file, and sorts them into stems and their lines.
class StrokeReader {
public:
    StrokeReader(LineSketchFile const& file, Smoothing smoothing)
        : file_(file)
        , smoothing_(smoothing)
    {
    }

    Result<LineDrawing> read()
    {
        std::size_t point_count = 0;
        for (auto const& stroke : file_.strokes)
            point_count += stroke.size();
        TRY(check_point_count(point_count));
        auto const count = file_.strokes.size();
        drawing_.roles.assign(count, name_of(Role::Unsure));
        drawing_.stems_of_strokes.assign(count, 0);
        drawing_.lines_of_strokes.assign(count, std::nullopt);
        TRY(find_stems());
        drawing_.stems = recogniser_.stems();
        for (std::size_t i = 0; i < drawing_.stems.size(); ++i)
            explain(i);
        std::sort(drawing_.unplaced.begin(), drawing_.unplaced.end());
        return std::move(drawing_);
    }

private:
    // Finds the stem to which each stroke belongs, and the strokes that are not flat.
    Result<void> find_stems()
    {
        // The newest stem so far; the depth of each later stroke is compared with its length.
        std::vector<Vec3> stem_before;
        nodes_of_stems_ = { file_.sketch.nodes_per_layer };
        for (std::size_t i = 0; i < file_.strokes.size(); ++i) {
            auto points = without_repeats(file_.strokes[i]);
            if (points.size() < 2) {
                leave_out(i, "it is only a dot");
                continue;
            }
            auto const stem = file_.stem_strokes.find(i);
            auto says = StemRecogniser::Says::Nothing;
            if (stem != file_.stem_strokes.end())
                says = StemRecogniser::Says::AnotherStem;
            else if (depth_of(points, stem_before) > kFlat)
                says = StemRecogniser::Says::InSpace;
            auto const& known = recogniser_.add(points, says);
            if (known.line.role == Role::Stem)
                stem_before = points;
            if (stem != file_.stem_strokes.end()) {
                nodes_of_stems_.resize(known.stem + 1);
                nodes_of_stems_[known.stem] = stem->second;
            }
            drawing_.stems_of_strokes[i] = known.stem;
            placed_.push_back({ i, std::move(points), known });
        }
        if (placed_.empty())
            return fail(Fault::User, "stroke 1 is only a dot: leave it out");
        return {};
    }

    void leave_out(std::size_t stroke, std::string const& reason)
    {
        drawing_.unplaced.push_back(stroke);
        drawing_.notes.push_back(fmt::format("stroke {} is left out: {}", stroke + 1, reason));
    }

    // Interprets together all strokes that belong to a stem.
    void explain(std::size_t stem)
    {
        std::vector<StrokeToExplain> strokes;
        std::vector<std::size_t> numbers;
        bool const is_one_of_several = drawing_.stems.size() > 1;
        for (auto const& [number, points, known] : placed_) {
            if (known.stem != stem)
                continue;
            StrokeToExplain stroke { .points = points,
                                     .is_by_hand = smoothing_ == Smoothing::Hand };
            if (known.line.role == Role::Around
                || (is_one_of_several && known.line.role == Role::Stem))
                stroke.assigned = known.line.role;
            strokes.push_back(std::move(stroke));
            numbers.push_back(number);
        }
        auto explanation = std::move(explain_sketch(strokes).front());
        for (std::size_t i = 0; i < strokes.size(); ++i)
            name(numbers, explanation.strokes[i], numbers[i]);
        auto& sketch = drawing_.stems[stem].sketch;
        sketch = std::move(explanation.sketch);
        sketch.organs_per_layer = file_.layers;
        sketch.nodes_per_layer = nodes_for(sketch, stem);
    }

    void name(std::vector<std::size_t> const& numbers, ExplainedStroke const& stroke,
              std::size_t number)
    {
        drawing_.roles[number] = name_of(stroke.role);
        if (stroke.role == Role::Unsure)
            return leave_out(number, stroke.reason);
        if (stroke.is_drawn_reversed)
            drawing_.notes.push_back(fmt::format(
                "stroke {} was drawn from the stem's top: it is turned round", number + 1));
        if (!stroke.of)
            return;
        auto const first = numbers[*stroke.of];
        drawing_.lines_of_strokes[number] = first;
        drawing_.notes.push_back(fmt::format("stroke {} is a part of the line of stroke {}: {}",
                                             number + 1, first + 1, name_of(stroke.role)));
    }

    // Number of nodes for each layer of a stem. A file of strokes need not give as many numbers as
    // there are layers, because its author cannot know how many layers the strokes make.
    std::vector<int> nodes_for(LineSketch const& sketch, std::size_t stem)
    {
        constexpr int kNodes = 8; // Number of nodes that the line tool uses by default.
        auto const& given = nodes_of_stems_[stem];
        auto const layers = std::max<std::size_t>(2, sketch.inclinations.size()) - 1;
        if (given.empty())
            return std::vector<int>(layers, kNodes);
        if (given.size() == layers)
            return given;
        std::vector<int> nodes;
        for (std::size_t i = 0; i < layers; ++i)
            nodes.push_back(given[std::min(i, given.size() - 1)]);
        drawing_.notes.push_back(
            fmt::format("the strokes make {} layers, and there are numbers of nodes for {}: the "
                        "layers have {} from below",
                        layers, given.size(), fmt::join(nodes, ", ")));
        return nodes;
    }

    struct Placed {
        std::size_t number = 0;
        std::vector<Vec3> points;
        KnownLine known {};
    };

    LineSketchFile const& file_;
    Smoothing smoothing_;
    StemRecogniser recogniser_;
    LineDrawing drawing_;
    std::vector<Placed> placed_;
    std::vector<std::vector<int>> nodes_of_stems_;
};

namespace fs = std::filesystem;

// Reads the sketches that serve as organs of other sketches.
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
    // Files that are being read: first the outermost sketch, last the sketch read now.
    std::vector<fs::path> chain_ {};
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
        return StrokeReader(file, smoothing).read();
    LineDrawing drawing;
    auto const add = [&](LineSketch const& sketch) {
        add_stem(drawing.stems, smoothing == Smoothing::Hand ? captured(sketch) : sketch);
    };
    add(file.sketch);
    std::for_each(file.further_stems.begin(), file.further_stems.end(), add);
    for (auto& stem : drawing.stems)
        stem.sketch.organs_per_layer = file.layers;
    return drawing;
}

} // namespace tractus::lines
