#include "app/batch/job.h"

#include "app/batch/pictures.h"
#include "app/batch/plant_group.h"
#include "app/batch/plant_page.h"
#include "app/batch/plant_season.h"
#include "app/batch/session_plant.h"
#include "app/render/contact_sheet.h"
#include "engine/base/file.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/level_of_detail.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/scene/varied_scene.h"
#include "engine/variation/growth.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace tractus::batch {

namespace {

constexpr PictureSize kTile { 420, 420 };

// Coarse mesh options for the sheet's tiles, in which even the thickest trunk is only a few pixels
// wide.
constexpr mesh::MeshOptions kTileMesh { .min_sides = 3, .max_sides = 8, .subdivision = 2 };

// Returns the number of columns for a sheet or field of `count` plants. It is slightly wider than
// high, or has one column fewer if all rows are then full.
int columns(std::size_t count)
{
    auto const wide = static_cast<std::size_t>(std::ceil(std::sqrt(1.2 * double(count))));
    bool const is_fuller = wide > 1 && count % wide != 0 && count % (wide - 1) == 0;
    return static_cast<int>(is_fuller ? wide - 1 : wide);
}

// The plants of a job: the variations of the drawing and, if requested, the unvaried drawing in
// each season.
class Sequence {
public:
    static Result<Sequence> create(scene::Scene const& scene, JobOptions const& options)
    {
        Sequence sequence(options, scene, TRY(PlantGroup::create(scene)));
        sequence.set_up(sequence.group_);
        if (options.all_seasons)
            for (auto const* name : { "spring", "summer", "autumn", "winter" }) {
                auto season = options.growth.season.value_or(scene::Season());
                season.month = scene::parse_month(name).value();
                auto const there = TRY(with_season(scene, season));
                sequence.seasons_.push_back({ name, TRY(shown_plants(there)) });
            }
        return sequence;
    }

    std::size_t size() const { return options_->variations + seasons_.size(); }

    // Returns the number of a variation, counted from 1, or the name of a season.
    std::string name(std::size_t index) const
    {
        return index < options_->variations ? fmt::format("{}", index + 1) : season(index).name;
    }

    // Returns the plant of an index, valid until the next call.
    Plant const& grow(std::size_t index)
    {
        return index < options_->variations ? variation(static_cast<std::uint32_t>(index))
                                            : season(index).plant;
    }

    // True if the last returned variation has branches below the ground.
    bool has_underground() const { return underground_ > 0; }

private:
    struct InSeason {
        std::string name;
        Plant plant;
    };

    Sequence(JobOptions const& options, scene::Scene const& scene, PlantGroup group)
        : options_(&options)
        , scene_(&scene)
        , own_seeds_(scene, options.individuality.seeds)
        , group_(std::move(group))
    {
    }

    void set_up(PlantGroup& group) const
    {
        if (options_->growth.along_ground)
            group.keep_above_ground();
        group.make_individuals(options_->individuality);
    }

    Plant const& variation(std::uint32_t index)
    {
        variation::PlantKey const key { options_->seed, index };
        auto const& how = options_->individuality;
        auto* group = &group_;
        if (own_seeds_.has(key)) {
            auto own = PlantGroup::create(own_seeds_.scene_of(*scene_, key));
            if (own) {
                group = &own_.emplace(*std::move(own));
                set_up(*group);
            }
        }
        auto const& plant = group->grow(key, variation::individual_age(key, how, options_->age));
        underground_ = group->underground();
        return plant;
    }

    InSeason const& season(std::size_t index) const
    {
        return seasons_[index - options_->variations];
    }

    JobOptions const* options_;
    scene::Scene const* scene_;
    scene::SeedAssignment own_seeds_;
    PlantGroup group_;
    std::optional<PlantGroup> own_; // The group of the last plant that had its own seed.
    std::size_t underground_ = 0;
    std::vector<InSeason> seasons_;
};

// Beginning of the report's line that names the log.
constexpr std::string_view kReportBegins = "log                   ";

// A job in progress; each member function carries out one stage.
class Job {
public:
    Job(JobOptions const& options, terminal::Progress& progress)
        : options_(options)
        , progress_(progress)
    {
    }

    Result<JobReport> run();

private:
    Result<scene::Scene> load_plant();
    Result<Drawing> read_drawing(scene::Scene scene);
    Result<void> draw_base(Drawing const& drawing);
    Result<void> make_collection(scene::Scene const& scene);
    Result<void> write_picture(std::string const& name, render::Image const& picture);
    mesh::Mesh mesh_for_file(Plant const& plant) const;
    Result<void> write_collection(Bounds const& frame, Sequence& sequence);
    Result<void> write_index(std::span<exports::PlacedMesh const> plants);

    JobOptions const& options_;
    terminal::Progress& progress_;
    PictureMaker* pictures_ = nullptr;
    std::optional<session::Session> session_;
    JobReport report_;
};

Result<JobReport> Job::run()
{
    auto scene = TRY(load_plant());
    auto const drawing = TRY(read_drawing(std::move(scene)));
    auto pictures = TRY(PictureMaker::create());
    pictures_ = &pictures;
    auto const path = options_.folder / "report.txt";
    // Writes a preliminary report, by which check_job_folder() recognises the folder after a run
    // that was killed.
    TRY(write_file(path, fmt::format("{}{}\nnot finished\n", kReportBegins, report_.log)));
    TRY(draw_base(drawing));
    TRY(make_collection(drawing.scene));
    progress_.finish();
    report_.times = progress_.times();
    report_.files.push_back(path);
    TRY(write_file(path, print_report(report_)));
    return report_;
}

Result<scene::Scene> Job::load_plant()
{
    progress_.begin("deriving the plant");
    auto const kinds = options_.drawing.methods.edits;
    auto const edits
        = TRY(growing_plant_edits({ options_.model, kinds }, options_.growth, options_.seed));
    auto scene = TRY(growing_plant(options_.model, edits));
    if (!options_.session.empty()) {
        session_ = TRY(begin_session(options_.session, edits, kinds));
        report_.files.push_back(options_.session);
    }
    report_.growth = options_.growth;
    report_.age = options_.age;
    report_.seed = options_.seed;
    report_.model = options_.model.empty() ? "an empty sheet" : options_.model.string();
    report_.notes = scene.model_warnings;
    report_.segments = scene.base->segment_count();
    report_.organs = scene.base->organs.size();
    return scene;
}

Result<Drawing> Job::read_drawing(scene::Scene scene)
{
    if (!session_)
        return batch::read_drawing(options_.drawing, std::move(scene), progress_, report_);
    document::Document document(*std::exchange(session_, std::nullopt),
                                document::Document::Working::AtOnce, following_edits);
    return batch::read_drawing(options_.drawing, document, progress_, report_);
}

Result<void> Job::write_picture(std::string const& name, render::Image const& picture)
{
    auto const path = options_.folder / name;
    auto const write = [&](std::ostream& out) { return render::write_png(out, picture); };
    TRY(write_file(path, write));
    report_.files.push_back(path);
    return {};
}

Result<void> Job::draw_base(Drawing const& drawing)
{
    progress_.begin("drawing the base plant and the strokes");
    auto const mesh = mesh::make_mesh(*drawing.scene.in_season);
    report_.triangles = mesh.triangle_count();
    TRY(write_picture("base.png", pictures_->plant(mesh, options_.picture)));
    TRY(write_picture(
        "strokes.png",
        pictures_->strokes(drawing.scene, drawing.strokes, drawing.nib, options_.picture)));
    return {};
}

Result<void> Job::make_collection(scene::Scene const& scene)
{
    auto plants = TRY(Sequence::create(scene, options_));
    // Grows each plant anew whenever it is needed, as all plants together would need much memory.
    auto const plant = [&](std::size_t index) -> Plant const& { return plants.grow(index); };
    auto const count = plants.size();
    report_.plants = count;

    progress_.begin("growing the collection", options_.variations);
    // Fits the largest plant, as all plants are shown at the same scale.
    render::Framing framing({}, kTile.aspect());
    Bounds frame;
    std::size_t underground = 0;
    // Pictures in seasons do not count for the framing, as fallen leaves would enlarge it.
    for (std::size_t i = 0; i < options_.variations; ++i) {
        // Uses the mesh for framing, as leaves and petals protrude from the branches.
        auto const mesh = mesh::make_mesh(plant(i));
        underground += plants.has_underground() ? 1 : 0;
        framing.add(mesh);
        if (auto const box = mesh::bounds(mesh); !box.empty()) {
            frame.add(box.min_mm);
            frame.add(box.max_mm);
        }
        progress_.step();
    }
    if (underground > 0)
        report_.notes.push_back(fmt::format("{} of {} plants have branches below the ground: "
                                            "--along-ground bends them along it",
                                            underground, options_.variations));

    progress_.begin("drawing the collection", count);
    std::vector<render::SheetTile> tiles;
    for (std::size_t i = 0; i < count; ++i) {
        auto const& grown = plant(i);
        if (i == 0)
            TRY(write_picture("varied.png",
                              pictures_->plant(mesh::make_mesh(grown), options_.picture)));
        tiles.push_back(
            { pictures_->plant(mesh::make_mesh(grown, kTileMesh), kTile, framing.camera()),
              plants.name(i) });
        progress_.step();
    }
    render::SheetStyle style;
    style.columns = columns(count);
    TRY(write_picture("collection.png", render::contact_sheet(tiles, style)));
    return write_collection(frame, plants);
}

mesh::Mesh Job::mesh_for_file(Plant const& plant) const
{
    double const share = options_.detail;
    if (share >= 1)
        return mesh::make_mesh(plant, options_.mesh);
    return mesh::make_mesh(
        mesh::coarser_plant(plant, options_.mesh, share, mesh::CoarserOrgans::KeepFew),
        mesh::coarser_options(options_.mesh, share));
}

Result<void> Job::write_collection(Bounds const& frame, Sequence& sequence)
{
    // Distance between neighbours as a multiple of a plant's width; exceeds 1 so that they do not
    // touch.
    constexpr double kPlantSpacing = 1.15;
    progress_.begin("writing the collection");
    double const width_mm = frame.empty() ? 0 : (frame.max_mm - frame.min_mm).head<2>().maxCoeff();
    double const spacing_mm = kPlantSpacing * std::max(width_mm, 1.0);
    auto const row = static_cast<std::size_t>(columns(sequence.size()));
    std::vector<exports::PlacedMesh> plants;
    for (std::size_t i = 0; i < sequence.size(); ++i)
        plants.push_back(
            { .name = fmt::format("{} {}",
                                  options_.model.empty() ? "plant" : options_.model.stem().string(),
                                  sequence.name(i)),
              .position_mm
              = spacing_mm * Vec3(static_cast<double>(i % row), -static_cast<double>(i / row), 0),
              .mesh = std::function<mesh::Mesh()>(
                  [this, &sequence, i] { return mesh_for_file(sequence.grow(i)); }) });
    auto const path = options_.folder / "collection.glb";
    auto const write = [&](std::ostream& out) -> Result<void> {
        auto const summary = TRY(exports::write_glb(out, plants, options_.glb));
        report_.collection_triangles = summary.triangles;
        return {};
    };
    TRY(write_file(path, write));
    report_.files.push_back(path);
    return options_.has_page ? write_index(plants) : Result<void> {};
}

Result<void> Job::write_index(std::span<exports::PlacedMesh const> plants)
{
    auto const path = options_.folder / "index.html";
    auto const write = [&](std::ostream& out) -> Result<void> {
        TRY(write_page(out, options_.model.stem().string(), plants, {}));
        return {};
    };
    TRY(write_file(path, write));
    report_.files.push_back(path);
    return {};
}

} // namespace

Result<void> check_job_folder(std::filesystem::path const& folder)
{
    auto const report = folder / "report.txt";
    std::ifstream in(report);
    if (std::string first; std::getline(in, first) && first.starts_with(kReportBegins))
        return {};
    std::error_code error;
    for (char const* const name : { "report.txt", "base.png", "strokes.png", "varied.png",
                                    "collection.png", "collection.glb", "index.html" })
        if (std::filesystem::exists(folder / name, error))
            return fail(Fault::User,
                        fmt::format("{} is there, and no earlier run of tractus wrote it: choose "
                                    "another folder with --output, or say --force",
                                    (folder / name).string()));
    return {};
}

Result<JobReport> run_job(JobOptions const& options, terminal::Progress& progress)
{
    return Job(options, progress).run();
}

std::string print_report(JobReport const& report)
{
    std::string text = fmt::format("{}{}\nmodel                 {}\nseed                  {}\n",
                                   kReportBegins, report.log, report.model, report.seed);
    if (report.age != 1)
        text += fmt::format("age                   {}\n", report.age);
    if (report.growth.preset || report.growth.variability != 1)
        text += fmt::format("growth                {}, variability {}\n",
                            growth_name(report.model, report.growth), report.growth.variability);
    if (report.growth.season)
        text += fmt::format("season                {}\n",
                            scene::month_name(report.growth.season->month));
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

} // namespace tractus::batch
