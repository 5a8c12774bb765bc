#include "app/batch/collection.h"

#include "app/batch/collection_grower.h"
#include "app/batch/collection_manifest.h"
#include "app/batch/collection_sheet.h"
#include "app/batch/picture_thread.h"
#include "app/batch/plant_billboard.h"
#include "app/batch/plant_page.h"
#include "engine/base/file.h"
#include "engine/base/random.h"
#include "engine/mesh/level_of_detail.h"
#include "engine/plant/join_plants.h"
#include "engine/variation/growth.h"
#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <functional>
#include <numbers>
#include <set>

namespace tractus::batch {

namespace {

// Maximum number of plants compared for the report's diversity.
constexpr std::size_t kCompared = 64;
constexpr std::size_t kMeasured = 8; // Maximum number of plants measured to find the spacing.
// Spacing as a multiple of the measured plants' greatest width. Exceeds 1, as leaves protrude and
// other plants may be wider.
constexpr double kSpacing = 1.15;
// Maximum random displacement of a plant along each axis of the grid, as a share of the spacing.
constexpr double kScatter = 0.35;
constexpr std::uint32_t kPlaces = 0x706C; // Random stream of plant ages and places.

// Returns the index of a shard's first plant; the shard ends where the next one begins. The
// computation avoids a product that could overflow.
std::size_t first_plant(CollectionOptions const& options, std::size_t shard)
{
    auto const parts = options.shard.parts;
    auto const before = shard - 1;
    return options.count / parts * before + options.count % parts * before / parts;
}

Result<void> check_count(CollectionOptions const& options)
{
    auto const shard = options.shard.number;
    auto const count = first_plant(options, shard + 1) - first_plant(options, shard);
    if (count <= kMaxPlantsInShard)
        return {};
    auto const parts = (options.count + kMaxPlantsInShard - 1) / kMaxPlantsInShard;
    return fail(Fault::User,
                fmt::format("{} plants are too many for one run, which makes {}: make them in "
                            "parts, with --shard 1/{} and so on",
                            count, kMaxPlantsInShard, parts));
}

// A collection in progress; each member function carries out one stage.
class Collection {
public:
    Collection(CollectionOptions const& options, terminal::Progress& progress)
        : options_(options)
        , progress_(progress)
    {
    }
    Collection(Collection const&) = delete;
    Collection& operator=(Collection const&) = delete;

    Result<CollectionReport> run();

private:
    Result<scene::Scene> load();
    Result<void> compare(CollectionGrower& grower);
    double spacing_mm(CollectionGrower& grower);
    Result<std::vector<ManifestPlant>> write_one_file(CollectionGrower& grower,
                                                      std::vector<PlantPlace> const& places);
    Result<std::vector<ManifestPlant>> write_folder(CollectionGrower& grower,
                                                    std::vector<PlantPlace> const& places);
    Result<void> write_sheet(CollectionGrower& grower, std::vector<PlantPlace> const& places);
    exports::PlacedMesh placed(PlantPlace const& place) const;
    void add_details(exports::PlacedMesh& mesh, std::function<Plant()> const& plant);
    exports::Billboard billboard(Plant const& plant);
    Result<exports::GlbSummary> write_plants(std::ostream& out,
                                             std::span<exports::PlacedMesh const> plants,
                                             exports::GlbOptions const& glb);
    exports::GlbOptions options_of_folder(std::size_t plants) const;

    // Returns the plant at its age, valid until the next call. `place` must belong to this
    // collection.
    Plant const& grow(CollectionGrower& grower, PlantPlace const& place);

    std::optional<mesh::WindKey> wind(PlantPlace const& place) const
    {
        return options_.has_wind ? std::optional(mesh::WindKey { options_.seed, place.index })
                                 : std::nullopt;
    }

    variation::PlantKey key(std::size_t index) const
    {
        return { options_.seed, static_cast<std::uint32_t>(index) };
    }

    CollectionOptions const& options_;
    terminal::Progress& progress_;
    CollectionReport report_;
    std::set<std::uint32_t> underground_; // Indices of plants with segments below the ground.
    Plant young_;
    Plant turned_; // The plant last drawn on the contact sheet, rotated as in the collection.
    // Thread that renders pictures; no value if no pictures are requested.
    std::optional<PictureThread> pictures_;
    std::optional<Error> picture_error_;
    mesh::MeshOptions mesh_; // options_.mesh with the error of organs.
};

Result<CollectionReport> Collection::run()
{
    // Checks everything that can fail early before the work begins.
    TRY(check_count(options_));
    TRY(check_writable(manifest_path(options_)));
    if (!options_.sheet.empty())
        TRY(check_writable(options_.sheet));
    if (!options_.sheet.empty() || options_.details > 0)
        pictures_.emplace(TRY(PictureThread::create()));
    auto const scene = TRY(load());
    auto grower = TRY(CollectionGrower::create(scene, options_.construction));
    if (options_.growth.along_ground)
        grower.keep_above_ground();
    grower.reseed(options_.individuality.seeds);
    grower.make_individuals(options_.individuality);
    TRY(compare(grower));
    mesh_ = options_.mesh;
    mesh_.organ_error_mm = options_.organ_error * report_.height_mm;
    auto how = options_.individuality;
    how.turn = 0; // Individuals are not turned, as plants are turned when placed.
    grower.make_individuals(how);
    auto const places = place_plants(options_, spacing_mm(grower));
    bool const one_file = is_one_file(options_);
    auto const plants
        = TRY(one_file ? write_one_file(grower, places) : write_folder(grower, places));
    report_.plants = plants.size();

    if (grower.failed_count() > 0)
        report_.notes.push_back(fmt::format("{} of the plants could not be built otherwise than "
                                            "they were drawn: they differ by their growth alone",
                                            grower.failed_count()));
    if (!underground_.empty())
        report_.notes.push_back(fmt::format("{} of {} plants have branches below the ground: "
                                            "--along-ground bends them along it",
                                            underground_.size(), plants.size()));
    report_.manifest = manifest_path(options_);
    auto const write
        = [&](std::ostream& out) { return write_manifest(out, options_, report_, plants); };
    TRY(write_file(report_.manifest, write));
    if (!options_.sheet.empty())
        TRY(write_sheet(grower, places));
    progress_.finish();
    return report_;
}

Result<scene::Scene> Collection::load()
{
    progress_.begin("deriving the plant");
    auto scene = TRY(
        load_growing_plant({ options_.model, options_.kinds }, options_.growth, options_.seed));
    report_.segments = scene.base->segment_count();
    report_.notes = scene.model_warnings;
    if (!options_.drawing)
        return scene;
    auto drawing
        = TRY(read_drawing(*options_.drawing, std::move(scene), progress_, report_.drawing));
    report_.notes.insert(report_.notes.end(), report_.drawing.notes.begin(),
                         report_.drawing.notes.end());
    return std::move(drawing.scene);
}

// Compares plants node by node, including their size, orientation and missing branches. Plants with
// different sketched parts cannot be compared.
Result<void> Collection::compare(CollectionGrower& grower)
{
    auto const drawn = TRY(grower.drawn());
    auto const box = bounds(drawn);
    report_.height_mm = box.empty() ? 0 : box.max_mm.z() - box.min_mm.z();
    if (!grower.has_one_topology())
        return {};
    auto const count = std::min(options_.count, kCompared);
    progress_.begin("comparing the plants", count);
    variation::Diversity diversity(drawn);
    for (std::size_t i = 0; i < count; ++i) {
        auto const age = variation::individual_age(key(i), options_.individuality);
        diversity.add(grower.comparable(key(i), age));
        progress_.step();
    }
    report_.between_plants = diversity.between_plants();
    report_.from_drawn = diversity.from_drawn();
    return {};
}

// Returns the distance between neighbouring plants, which is the same in all shards.
double Collection::spacing_mm(CollectionGrower& grower)
{
    double width_mm = 1;
    for (std::size_t i = 0; i < std::min(options_.count, kMeasured); ++i) {
        auto const box = bounds(grower.grow(key(i)));
        if (!box.empty())
            width_mm = std::max(width_mm, (box.max_mm - box.min_mm).head<2>().maxCoeff());
    }
    return kSpacing * width_mm;
}

Plant const& Collection::grow(CollectionGrower& grower, PlantPlace const& place)
{
    auto const& grown = grower.grow(key(place.index), place.age);
    if (grower.underground() > 0)
        underground_.insert(place.index);
    if (place.age == 1)
        return grown;
    young_ = variation::without_unborn(grown);
    return young_;
}

exports::PlacedMesh Collection::placed(PlantPlace const& place) const
{
    exports::PlacedMesh mesh;
    mesh.name = fmt::format("{} {}", options_.model.stem().string(), place.index + 1);
    return mesh;
}

// Adds levels of detail to a mesh. Each level is meant for the screen coverage at which its
// triangles cover about as many pixels as those of the finest level at full coverage.
void Collection::add_details(exports::PlacedMesh& mesh, std::function<Plant()> const& plant)
{
    constexpr double kFullCoverage = 0.2;
    if (options_.details == 0)
        return;
    double share = 1;
    mesh.min_coverage = kFullCoverage;
    for (std::size_t level = 1; level < options_.details; ++level) {
        share /= 2;
        mesh.details.push_back(
            { exports::PlantToMesh {
                  .plant
                  = [this, plant, share] { return mesh::coarser_plant(plant(), mesh_, share); },
                  .options = mesh::coarser_options(mesh_, share),
                  .wind = std::get<exports::PlantToMesh>(mesh.mesh).wind },
              kFullCoverage * share });
    }
    mesh.details.push_back(
        { std::function<exports::Billboard()>([this, plant] { return billboard(plant()); }), 0 });
}

// Draws a billboard. The first error is stored, as it cannot be returned to the caller.
exports::Billboard Collection::billboard(Plant const& plant)
{
    // Share of the triangles to keep for a billboard; its few pixels could not show more.
    constexpr double kShare = 0.25;
    auto const coarse = mesh::coarser_plant(plant, mesh_, kShare);
    auto const mesh = mesh::make_mesh(coarse, mesh::coarser_options(mesh_, kShare));
    Result<exports::Billboard> drawn;
    pictures_->draw([&](PictureMaker& pictures) { drawn = draw_billboard(pictures, mesh); });
    if (drawn)
        return *std::move(drawn);
    if (!picture_error_)
        picture_error_ = drawn.error();
    return {};
}

// Options for the files of a folder: before a file is written, the expected size of all of them is
// announced, which is that of the file times the number of plants.
exports::GlbOptions Collection::options_of_folder(std::size_t plants) const
{
    auto options = options_.glb;
    if (options.before_writing)
        options.before_writing
            = [announce = options.before_writing, plants](exports::GlbSummary const& one) {
                  announce({ .bytes = one.bytes * plants,
                             .triangles = one.triangles * plants,
                             .compressed_bytes = one.compressed_bytes * plants,
                             .files = plants });
              };
    return options;
}

Result<exports::GlbSummary> Collection::write_plants(std::ostream& out,
                                                     std::span<exports::PlacedMesh const> plants,
                                                     exports::GlbOptions const& glb)
{
    auto const summary = TRY(exports::write_glb(out, plants, glb));
    if (picture_error_)
        return fail(picture_error_->fault, picture_error_->message);
    return summary;
}

Result<std::vector<ManifestPlant>> Collection::write_one_file(CollectionGrower& grower,
                                                              std::vector<PlantPlace> const& places)
{
    progress_.begin("writing the plants", places.size());
    std::vector<ManifestPlant> plants;
    std::vector<exports::PlacedMesh> meshes;
    std::size_t begun = 0;
    bool const is_page = options_.output.extension() == ".html";
    for (auto const& place : places) {
        plants.push_back({ place, options_.output.filename().string() });
        meshes.push_back(placed(place));
        meshes.back().position_mm = place.position_mm;
        meshes.back().rotation_rad = place.rotation_rad;
        auto const make = [this, &grower, &begun, &place, number = plants.size()]() -> Plant {
            // Counts each plant once, although plants are made anew for each level of detail.
            if (number > begun) {
                begun = number;
                progress_.step();
            }
            return grow(grower, place);
        };
        meshes.back().mesh = exports::PlantToMesh { make, mesh_, wind(place) };
        if (!is_page)
            add_details(meshes.back(), make);
    }
    auto const write = [&](std::ostream& out) -> Result<void> {
        auto const title = options_.model.stem().string();
        auto const summary = TRY(is_page ? write_page(out, title, meshes, options_.glb)
                                         : write_plants(out, meshes, options_.glb));
        report_.triangles = summary.triangles;
        report_.bytes = static_cast<std::uint64_t>(out.tellp());
        return {};
    };
    TRY(write_file(options_.output, write));
    return plants;
}

Result<std::vector<ManifestPlant>> Collection::write_folder(CollectionGrower& grower,
                                                            std::vector<PlantPlace> const& places)
{
    progress_.begin("writing the plants", places.size());
    auto const digits = std::to_string(options_.count).size();
    auto const glb = options_of_folder(places.size());
    std::vector<ManifestPlant> plants;
    for (auto const& place : places) {
        auto const file
            = fmt::format("{}-{:0{}}.glb", options_.model.stem().string(), place.index + 1, digits);
        auto mesh = placed(place);
        auto const& plant = grow(grower, place);
        mesh.mesh = exports::PlantToMesh { &plant, mesh_, wind(place) };
        add_details(mesh, [&] { return plant; });
        auto const write = [&](std::ostream& out) -> Result<void> {
            auto const summary = TRY(write_plants(out, { &mesh, 1 }, glb));
            report_.triangles += summary.triangles;
            report_.bytes += summary.bytes;
            return {};
        };
        if (auto const written = write_file(options_.output / file, write); !written)
            return fail(written.error().fault,
                        fmt::format("{}; {} of {} plants are written", written.error().message,
                                    plants.size(), places.size()));
        plants.push_back({ place, file });
        progress_.step();
    }
    return plants;
}

Result<void> Collection::write_sheet(CollectionGrower& grower,
                                     std::vector<PlantPlace> const& places)
{
    SheetPlants const plants {
        places.size(),
        [&](std::size_t i) -> Plant const& {
            turned_ = {};
            auto const about_z = Eigen::AngleAxisd(places[i].rotation_rad, Vec3::UnitZ());
            append_part(turned_, grow(grower, places[i]), { .turn = Quat(about_z) });
            return turned_;
        },
        [&](std::size_t i) {
            auto const& [index, age, position_mm, rotation_rad] = places[i];
            return age == 1 ? fmt::format("{}", index + 1)
                            : fmt::format("{}, age {:.2f}", index + 1, age);
        },
    };
    render::Image sheet;
    pictures_->draw([&](PictureMaker& pictures) {
        sheet = collection_sheet(pictures, plants, options_.sheet_tile, progress_);
    });
    TRY(write_file(options_.sheet,
                   [&](std::ostream& out) { return render::write_png(out, sheet); }));
    report_.sheet = options_.sheet;
    return {};
}

} // namespace

std::vector<PlantPlace> place_plants(CollectionOptions const& options, double spacing_mm)
{
    // The grid of plants is slightly wider than deep.
    auto const row
        = static_cast<std::size_t>(std::ceil(std::sqrt(1.2 * static_cast<double>(options.count))));
    std::vector<PlantPlace> places;
    auto const end = first_plant(options, options.shard.number + 1);
    for (std::size_t i = first_plant(options, options.shard.number); i < end; ++i) {
        PlantPlace place { .index = static_cast<std::uint32_t>(i) };
        Random random({ options.seed, kPlaces, place.index });
        place.age
            = variation::individual_age({ options.seed, place.index }, options.individuality,
                                        random.uniform(options.ages.youngest, options.ages.oldest));
        place.position_mm
            = spacing_mm * Vec3(static_cast<double>(i % row), -static_cast<double>(i / row), 0);
        if (options.stand == Stand::Scatter) {
            double const reach_mm = kScatter * spacing_mm;
            place.position_mm.x() += random.uniform(-reach_mm, reach_mm);
            place.position_mm.y() += random.uniform(-reach_mm, reach_mm);
        }
        place.rotation_rad = random.uniform(0, options.individuality.turn * 2 * std::numbers::pi);
        places.push_back(place);
    }
    return places;
}

Result<CollectionReport> make_collection(CollectionOptions const& options,
                                         terminal::Progress& progress)
{
    return Collection(options, progress).run();
}

std::string print_report(CollectionReport const& report)
{
    std::string text
        = fmt::format("{} plants of {} segments, {} triangles, {:.1f} MB\n", report.plants,
                      report.segments, report.triangles, static_cast<double>(report.bytes) / 1e6);
    auto const distance = [&](char const* name, variation::DistanceSpread const& spread) {
        if (spread.count > 0)
            text += fmt::format("{}: {:.1f} mm, +- {:.1f} mm ({:.1f} % of the height)\n", name,
                                spread.mean_mm, spread.deviation_mm,
                                100 * spread.mean_mm / std::max(report.height_mm, 1e-9));
    };
    distance("from plant to plant", report.between_plants);
    distance("from what was drawn", report.from_drawn);
    for (auto const& note : report.notes)
        text += fmt::format("note: {}\n", note);
    text += fmt::format("wrote {}\n", report.manifest.string());
    if (!report.sheet.empty())
        text += fmt::format("wrote {}\n", report.sheet.string());
    return text;
}

} // namespace tractus::batch
