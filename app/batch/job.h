#pragma once

#include "app/batch/drawing.h"
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

// The main job: a recorded drawing and a model become a set of varied plants. Where several plants
// were drawn each of the set is all of them.
struct JobOptions {
    DrawingOptions drawing {};
    std::filesystem::path model {};
    std::uint64_t seed = 1;             // Seed of the variations.
    std::size_t variations = 12;        // Plants in the collection; at least 1.
    std::filesystem::path folder = "."; // Made if it is not there.
    GrowthOptions growth {};
    // How much plants of one bed differ beside their growth.
    variation::Individuality individuality { .branches = 0.08, .size = 0.12, .turn = 1 };
    double age = 1;             // Age of all plants; see Grower::grow().
    bool all_seasons = false;   // Also the drawing itself in four seasons.
    exports::GlbOptions glb {}; // Options of the collection's file, as the next one.
    mesh::MeshOptions mesh {};
    std::filesystem::path session {}; // The new file that keeps what is drawn; empty: none.
};

// Facts about what was read, and what became of it.
struct JobReport : DrawingReport {
    std::string model;
    std::uint64_t seed = 1;
    GrowthOptions growth;
    double age = 1;
    std::size_t plants = 0;
    std::size_t segments = 0;  // Segments of one plant.
    std::size_t organs = 0;    // Organs of one plant.
    std::size_t triangles = 0; // Triangles of one plant.
    std::uint64_t collection_triangles = 0;
    std::vector<std::filesystem::path> files;
    std::vector<terminal::Progress::StageTime> times;
};

// Replays the log onto the model and writes base.png, strokes.png, varied.png, collection.png,
// collection.glb and report.txt into the folder. Each file appears whole or not at all; a session
// appears as the plant is loaded and holds each stroke as soon as it is drawn. Fails like
// growing_plant_edits() and read_drawing(), where a file cannot be written, and where the system
// has no OpenGL.
Result<JobReport> run_job(JobOptions const& options, terminal::Progress& progress);

// Fails, as the user's fault, if the folder already has files of the names that a job writes, and
// no report of an earlier job beside them: they would be somebody else's.
Result<void> check_job_folder(std::filesystem::path const& folder);

// The report as lines for a person to read, as they stand in report.txt.
std::string print_report(JobReport const& report);

} // namespace tractus::batch
