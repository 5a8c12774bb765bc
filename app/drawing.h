#pragma once

#include "app/progress.h"
#include "app/station.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

// How plants grow.
struct GrowthOptions {
    std::string preset = "usual"; // See growth_presets().
    double liking = 1;            // See at_liking().
};

// The scene of a model (load_plant_edit) that nothing was drawn on. Fails, as the user's fault, for
// what is no model, a plant without branches, or a growth that does not exist.
Result<Scene> load_growing_plant(std::filesystem::path const& model, GrowthOptions const& growth,
                                 std::uint64_t seed);

// A recorded drawing.
struct DrawingOptions {
    // A log, or a file of strokes (stroke_file.h), of which each shapes the next branch in drawing
    // order.
    std::filesystem::path log {};
    std::optional<std::filesystem::path> rig {}; // A calibration in place of the log's own.
    std::optional<std::string> height {};        // A height scenario in place of the height sensor.
    std::optional<double> speed {}; // Times the pace of the hand; no value: as fast as it is read.
};

// What was read of it.
struct DrawingReport {
    std::string log;
    std::size_t reports = 0;
    std::size_t broken_reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    std::size_t strokes = 0;
    // Paths that a stroke shapes; a branch chosen twice counts once.
    std::size_t branches_selected = 0;
    std::size_t indicators = 0;
    std::vector<std::string> notes; // Strokes that changed nothing, warnings: a sentence each.
};

// What was drawn, and the scene that it amounts to.
struct Drawing {
    Scene scene;
    std::vector<DrawnStroke> strokes;
};

// Draws it on `scene`, whose base plant is loaded. Tells `report` what was read, and adds to its
// notes. Fails, as the user's or a device's fault, if it cannot be read.
Result<Drawing> read_drawing(DrawingOptions const& options, Scene scene, Progress& progress,
                             DrawingReport& report);

} // namespace tractus
