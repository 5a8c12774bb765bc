#include "app/job.h"

#include "app/log_replay.h"
#include "app/model_cost.h"
#include "app/model_file.h"
#include "app/paced_log.h"
#include "app/pictures.h"
#include "app/render/contact_sheet.h"
#include "app/render/mesh_measures.h"
#include "app/stroke_file.h"
#include "calib/rig_file.h"
#include "drivers/file.h"
#include "drivers/log.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/variation/growth.h"
#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <functional>
#include <set>

namespace tractus {

namespace fs = std::filesystem;

namespace {

constexpr PictureSize kPicture { 1280, 960 };
constexpr PictureSize kTile { 420, 420 };

// Enough for a tile, in which the thickest trunk is a few pixels wide.
constexpr MeshOptions kTileMesh { .min_sides = 3, .max_sides = 8, .subdivision = 2 };

Result<void> make_folder(fs::path const& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail(Fault::User,
                    fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
    return {};
}

// Of a sheet or a field of `count` plants: a little wider than high.
int columns(std::size_t count)
{
    return static_cast<int>(std::ceil(std::sqrt(1.2 * static_cast<double>(count))));
}

// Why samples of the pen were lost, or stand in doubt.
void note_heights(FuserCounts const& counts, std::vector<std::string>& notes)
{
    if (counts.heights_refused > 0)
        notes.push_back(
            fmt::format("{} of {} height readings are not of the rig's calibration, and "
                        "were left out: calibrate again",
                        counts.heights_refused, counts.heights));
    if (counts.heights_uncalibrated > 0)
        notes.push_back(fmt::format("{} of {} height readings lie outside the calibrated range, "
                                    "where heights are guesses",
                                    counts.heights_uncalibrated, counts.heights));
    if (counts.pens_without_height > 0)
        notes.push_back(fmt::format("{} of {} pen samples had no height reading at their time, and "
                                    "were left out",
                                    counts.pens_without_height, counts.pens));
}

// One job on its way: each member function is a stage.
class Job {
public:
    Job(JobOptions const& options, Progress& progress)
        : options_(options)
        , progress_(progress)
    {
    }

    Result<JobReport> run();

private:
    Result<Scene> load_plant();
    // What was drawn, and what it amounts to.
    struct Drawing {
        Scene scene;
        std::vector<DrawnStroke> strokes;
    };

    Result<Drawing> read_drawing(Scene scene);
    Result<Drawing> read_strokes(Scene scene);
    Result<Station> replay(Scene scene);
    Result<void> draw_base(Drawing const& drawing);
    Result<void> make_collection(Scene const& scene);
    Result<void> write_picture(std::string const& name, Image const& picture);
    Result<void> write_collection(Bounds const& frame,
                                  std::function<Mesh(std::size_t)> const& mesh);
    void note_replay(Station const& station);
    void note_drawing(Drawing const& drawing);

    JobOptions const& options_;
    Progress& progress_;
    PictureMaker* pictures_ = nullptr;
    JobReport report_;
};

Result<JobReport> Job::run()
{
    TRY(make_folder(options_.folder));
    auto scene = TRY(load_plant());
    auto const drawing = TRY(read_drawing(std::move(scene)));
    note_drawing(drawing);
    auto pictures = TRY(PictureMaker::create());
    pictures_ = &pictures;
    TRY(draw_base(drawing));
    TRY(make_collection(drawing.scene));
    progress_.finish();
    report_.times = progress_.times();
    auto const path = options_.folder / "report.txt";
    report_.files.push_back(path);
    TRY(write_file(path, print_report(report_)));
    return report_;
}

Result<Scene> Job::load_plant()
{
    progress_.begin("deriving the plant");
    auto const edit = TRY(load_plant_edit(options_.model));
    auto scene = TRY(apply_edit({}, edit, load_options()));
    if (scene.base->segment_count() == 0)
        return fail(Fault::User,
                    fmt::format("{}: the plant has no branch that a stroke could shape: its "
                                "derivation draws nothing",
                                options_.model.string()));
    auto const preset = TRY(growth_preset(options_.growth.preset));
    auto const growth = TRY(at_liking(preset, options_.growth.liking));
    scene = TRY(apply_edit(scene, SetGrowth { growth, options_.seed }));
    report_.growth = options_.growth;
    report_.seed = options_.seed;
    report_.model = options_.model.string();
    report_.notes = scene.model_warnings;
    report_.segments = scene.base->segment_count();
    report_.organs = scene.base->organs.size();
    return scene;
}

// All of it, at a multiple of the hand's pace or at once.
static void play(LogReplay& replay, std::optional<double> const& speed)
{
    constexpr Duration kStep = std::chrono::milliseconds(10);
    if (!speed)
        return replay.run();
    auto const pace = pace_from_now(replay.begin(), *speed);
    while (replay.advance_to(pace.data_time(pace.now())))
        pace.wait(kStep);
}

Result<Job::Drawing> Job::read_drawing(Scene scene)
{
    if (is_stroke_file(options_.log))
        return read_strokes(std::move(scene));
    auto const station = TRY(replay(std::move(scene)));
    note_replay(station);
    return Drawing { station.scene(), station.strokes() };
}

// A file of strokes says nothing about branches, so they go to these in drawing order.
Result<Job::Drawing> Job::read_strokes(Scene scene)
{
    progress_.begin("reading the strokes");
    Drawing drawing { std::move(scene), {} };
    for (auto& stroke : TRY(load_strokes(options_.log))) {
        if (drawing.strokes.size() == drawing.scene.base->axes.size()) {
            report_.notes.push_back("there are more strokes than branches: the rest is left out");
            break;
        }
        drawing.strokes.push_back(
            draw(std::move(stroke), { .kind = Tool::Kind::DrawInOrder }, drawing.scene));
    }
    report_.log = options_.log.string();
    report_.strokes = drawing.strokes.size();
    return drawing;
}

Result<Station> Job::replay(Scene scene)
{
    progress_.begin("reading the log");
    auto const log = TRY(read_log(options_.log));
    report_.log = options_.log.string();
    if (auto const warnings = summarize_warnings(log); !warnings.empty())
        report_.notes.push_back(warnings);

    progress_.begin("replaying the log");
    ReplayOptions replay_options;
    replay_options.scene = std::move(scene);
    if (options_.rig)
        replay_options.rig = TRY(load_rig(*options_.rig));
    if (options_.height)
        replay_options.height = TRY(parse_height_scenario(*options_.height));
    auto replay = TRY(LogReplay::create(log, std::move(replay_options)));
    play(replay, options_.speed);
    auto const& counts = replay.station().counts();
    if (counts.pen_samples == 0 && counts.broken_reports > 0)
        return fail(Fault::Device,
                    fmt::format("{}: the reports are not what the report descriptors say, the "
                                "first: {}",
                                log.name, counts.first_broken));
    return std::move(replay).take_station();
}

void Job::note_replay(Station const& station)
{
    auto const& counts = station.counts();
    report_.reports = counts.reports;
    report_.broken_reports = counts.broken_reports;
    report_.pen_samples = counts.pen_samples;
    report_.height_samples = counts.height_samples;
    report_.strokes = counts.strokes;
    note_heights(station.fuser_counts(), report_.notes);
    for (auto& sentence : describe_faults(station.height_monitor(), {}))
        report_.notes.push_back(std::move(sentence));
    if (counts.strokes == 0)
        report_.notes.push_back(
            station.fuser_counts().pens_without_height > 0
                ? "no stroke has heights: the plants vary by chance alone"
                : "the pen never touched the tablet: the plants vary by chance alone");
    if (counts.broken_reports > 0)
        report_.notes.push_back(fmt::format("{} reports could not be decoded, the first: {}",
                                            counts.broken_reports, counts.first_broken));
}

void Job::note_drawing(Drawing const& drawing)
{
    report_.indicators = drawing.scene.indicators.size();
    std::set<std::vector<SegmentId>> paths;
    for (auto const& association : drawing.scene.associations)
        paths.insert(association.path);
    report_.branches_selected = paths.size();
    for (auto const& drawn : drawing.strokes)
        if (!drawn.refusal.empty())
            report_.notes.push_back(fmt::format("a stroke at {:.1f} s changed nothing: {}",
                                                to_seconds(drawn.stroke.tips.front().time),
                                                drawn.refusal));
}

Result<void> Job::write_picture(std::string const& name, Image const& picture)
{
    auto const path = options_.folder / name;
    auto const write = [&](std::ostream& out) { return write_png(out, picture); };
    TRY(write_file(path, write));
    report_.files.push_back(path);
    return {};
}

Result<void> Job::draw_base(Drawing const& drawing)
{
    progress_.begin("drawing the base plant and the strokes");
    auto const mesh = make_mesh(*drawing.scene.base);
    report_.triangles = mesh.triangle_count();
    TRY(write_picture("base.png", pictures_->plant(mesh, kPicture)));
    TRY(write_picture("strokes.png", pictures_->strokes(drawing.scene, drawing.strokes, kPicture)));
    return {};
}

Result<void> Job::make_collection(Scene const& scene)
{
    auto const plan = TRY(plan_growth(scene));
    Grower grower(plan);
    // Grown again whenever it is needed: that is quicker than keeping them all is large.
    Plant young;
    auto const plant = [&](std::size_t index) -> Plant const& {
        auto const& grown = grower.grow({ options_.seed, static_cast<std::uint32_t>(index) },
                                        options_.growth.age);
        if (options_.growth.age == 1)
            return grown;
        young = without_unborn(grown);
        return young;
    };
    report_.plants = options_.variations;

    progress_.begin("growing the collection", options_.variations);
    Bounds frame; // So that all are shown at one scale.
    for (std::size_t i = 0; i < options_.variations; ++i) {
        auto const box = bounds(make_mesh(plant(i))); // Leaves and petals stand out.
        frame.add(box.min_mm);
        frame.add(box.max_mm);
        progress_.step();
    }

    progress_.begin("drawing the collection", options_.variations);
    std::vector<SheetTile> tiles;
    for (std::size_t i = 0; i < options_.variations; ++i) {
        auto const& grown = plant(i);
        if (i == 0)
            TRY(write_picture("varied.png", pictures_->plant(make_mesh(grown), kPicture)));
        tiles.push_back({ pictures_->plant(make_mesh(grown, kTileMesh), kTile, frame),
                          fmt::format("{}", i + 1) });
        progress_.step();
    }
    SheetStyle style;
    style.columns = columns(options_.variations);
    TRY(write_picture("collection.png", contact_sheet(tiles, style)));
    return write_collection(frame, [&](std::size_t i) { return make_mesh(plant(i)); });
}

Result<void> Job::write_collection(Bounds const& frame,
                                   std::function<Mesh(std::size_t)> const& mesh)
{
    constexpr double kSpacing = 1.15; // Of a plant's width, so that neighbours do not touch.
    progress_.begin("writing the collection");
    double const spacing_mm
        = kSpacing * std::max((frame.max_mm - frame.min_mm).head<2>().maxCoeff(), 1.0);
    auto const row = static_cast<std::size_t>(columns(options_.variations));
    std::vector<PlacedMesh> plants;
    for (std::size_t i = 0; i < options_.variations; ++i)
        plants.push_back(
            { .name = fmt::format("{} {}", options_.model.stem().string(), i + 1),
              .position_mm
              = spacing_mm * Vec3(static_cast<double>(i % row), -static_cast<double>(i / row), 0),
              .mesh = std::function<Mesh()>([&mesh, i] { return mesh(i); }) });
    auto const path = options_.folder / "collection.glb";
    auto const write = [&](std::ostream& out) -> Result<void> {
        auto const summary = TRY(write_glb(out, plants));
        report_.collection_triangles = summary.triangles;
        return {};
    };
    TRY(write_file(path, write));
    report_.files.push_back(path);
    return {};
}

} // namespace

Result<JobReport> run_job(JobOptions const& options, Progress& progress)
{
    return Job(options, progress).run();
}

std::string print_report(JobReport const& report)
{
    std::string text = fmt::format(
        "log                   {}\nmodel                 {}\nseed                  {}\n",
        report.log, report.model, report.seed);
    if (report.growth.age != 1)
        text += fmt::format("age                   {}\n", report.growth.age);
    if (report.growth.preset != JobGrowth {}.preset || report.growth.liking != 1)
        text += fmt::format("growth                {}, {} as it likes\n", report.growth.preset,
                            report.growth.liking);
    auto const count = [&](char const* name, std::size_t value) {
        text += fmt::format("{:<22}{}\n", name, value);
    };
    count("reports read", report.reports);
    count("reports not decoded", report.broken_reports);
    count("pen samples", report.pen_samples);
    count("height samples", report.height_samples);
    count("strokes", report.strokes);
    count("branches selected", report.branches_selected);
    count("motion indicators", report.indicators);
    count("plants", report.plants);
    count("segments, each", report.segments);
    count("organs, each", report.organs);
    count("triangles, each", report.triangles);
    count("triangles, all", report.collection_triangles);
    double total_s = 0;
    for (auto const& [stage, seconds] : report.times) {
        text += fmt::format("{:>8.3f} s  {}\n", seconds, stage);
        total_s += seconds;
    }
    text += fmt::format("{:>8.3f} s  in all\n", total_s);
    for (auto const& note : report.notes)
        text += fmt::format("note: {}\n", note);
    for (auto const& file : report.files)
        text += fmt::format("wrote {}\n", file.string());
    return text;
}

} // namespace tractus
