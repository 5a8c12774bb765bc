#pragma once

#include "app/progress.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

// How a job's plants grow.
struct JobGrowth {
    std::string preset = "usual"; // See growth_presets().
    double liking = 1;            // See at_liking().
    double age = 1;               // See Grower::grow().
};

// The main job: a recorded drawing and a model become a set of varied plants.
struct JobOptions {
    // A drawing: a log, or a file of strokes (stroke_file.h), of which each shapes the next branch
    // in drawing order.
    std::filesystem::path log;
    std::filesystem::path model;
    std::optional<std::filesystem::path> rig; // A calibration in place of the log's own.
    std::optional<std::string> height;        // A height scenario in place of the height sensor.
    std::optional<double> speed {}; // Times the pace of the hand; no value: as fast as it is read.
    std::uint64_t seed = 1;         // Of the variations.
    std::size_t variations = 12;    // In the collection; at least 1.
    std::filesystem::path folder = "."; // Made if it is not there.
    JobGrowth growth {};
};

// What was read, and what became of it.
struct JobReport {
    std::string log;
    std::string model;
    std::uint64_t seed = 1;
    JobGrowth growth;
    std::size_t reports = 0;
    std::size_t broken_reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    std::size_t strokes = 0;
    // Paths that a stroke shapes; a branch chosen twice counts once.
    std::size_t branches_selected = 0;
    std::size_t indicators = 0;
    std::size_t plants = 0;
    std::size_t segments = 0;  // Of one plant.
    std::size_t organs = 0;    // Of one plant.
    std::size_t triangles = 0; // Of one plant.
    std::uint64_t collection_triangles = 0;
    std::vector<std::string> notes; // Strokes that changed nothing, warnings: a sentence each.
    std::vector<std::filesystem::path> files;
    std::vector<Progress::StageTime> times;
};

// Replays the log onto the model and writes base.png, strokes.png, varied.png, collection.png,
// collection.glb and report.txt into the folder. Each file appears whole or not at all.
Result<JobReport> run_job(JobOptions const& options, Progress& progress);

// The report as lines for a person to read, as they stand in report.txt.
std::string print_report(JobReport const& report);

} // namespace tractus
