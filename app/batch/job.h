#pragma once

#include "app/batch/drawing.h"
#include "app/render/picture_size.h"
#include "app/terminal/progress.h"
#include "engine/base/result.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tractus::batch {

// Options of the main job, which turns a recorded drawing on a model into a set of varied plants.
// If several plants were drawn, each member of the set contains all of them.
struct JobOptions {
    DrawingOptions drawing {};
    std::filesystem::path model {};
    std::uint64_t seed = 1;             // Seed of the variations.
    std::size_t variations = 12;        // Plants in the collection; at least 1.
    std::filesystem::path folder = "."; // Output folder, created if missing.
    GrowthOptions growth {};
    // Individual differences between the plants, in addition to differences in growth.
    variation::Individuality individuality = variation::kPlantsOfOneBed;
    double age = 1; // Age of the oldest plants, 1 for fully grown; see Grower::grow().
    // True: the collection also contains the unvaried drawing in each of four seasons.
    bool all_seasons = false;
    bool has_page = false; // True: index.html shows the collection in a browser (plant_page.h).
    exports::GlbOptions glb {}; // Options of collection.glb; those of its meshes are in `mesh`.
    mesh::MeshOptions mesh {};
    // Share of the triangles that plants keep in collection.glb, above 0 and at most 1. Organs of
    // which there are few all stay (mesh::coarser_plant()).
    double detail = 1;
    render::PictureSize picture {};   // Size of base.png, strokes.png and varied.png.
    std::filesystem::path session {}; // New session file that saves the drawing; empty: none.
};

// Statistics of the drawing, and of the files that the job wrote.
struct JobReport : DrawingReport {
    std::string model;
    std::uint64_t seed = 1;
    GrowthOptions growth;
    double age = 1;
    std::size_t plants = 0;
    std::size_t segments = 0;  // Number of segments of one plant.
    std::size_t organs = 0;    // Number of organs of one plant.
    std::size_t triangles = 0; // Number of triangles of one plant.
    std::uint64_t collection_triangles = 0;
    std::vector<std::filesystem::path> files;
    std::vector<terminal::Progress::StageTime> times;
};

// Replays the log onto the model and writes base.png, strokes.png, varied.png, collection.png,
// collection.glb and report.txt into the folder. Each file appears complete or not at all. A
// session is created when the plant is loaded and receives each stroke as soon as it is drawn.
// Fails like growing_plant_edits() and read_drawing(), if a file cannot be written, and if the
// system has no OpenGL.
Result<JobReport> run_job(JobOptions const& options, terminal::Progress& progress);

// Fails with a user error if the folder contains files named like a job's files, but no report.txt
// of an earlier job: such files may be the user's own.
Result<void> check_job_folder(std::filesystem::path const& folder);

// Formats the report for the user; report.txt has the same text.
std::string print_report(JobReport const& report);

} // namespace tractus::batch
