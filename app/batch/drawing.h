#pragma once

#include "app/document/document.h"
#include "app/document/draw.h"
#include "app/terminal/progress.h"
#include "app/tools/methods.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/nib.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::batch {

// Growth options of a command.
struct GrowthOptions {
    // One of growth_presets(). No value: a session's plants grow as saved in it, all others as
    // "usual".
    std::optional<std::string> preset {};
    double variability = 1; // Strength of the variation; see at_variability().
    // True: branches grow along the ground instead of into it; see bend_along_ground().
    bool along_ground = false;
    // Leaves as for foliage_edits(); empty: as saved in the session or model.
    std::string leaves {};
    // Season to show; no value: as saved in the session, otherwise none.
    std::optional<scene::Season> season {};
};

// Name of the growth preset of the plants of `model`, for reports and manifests.
std::string growth_name(std::filesystem::path const& model, GrowthOptions const& growth);

// A plant to draw on: its file and, if that is a session, the kinds of edits it may contain.
struct PlantChoice {
    // File of the plant; empty: an empty sheet, on which the drawing makes plants.
    std::filesystem::path model;
    scene::EditKinds kinds;
};

// Edits that load a plant to draw on, a model (load_plant_edit()) or a session with everything
// drawn in it, and that set its growth. Fails with a user error for any other file and for an
// unknown growth preset.
Result<std::vector<scene::Edit>>
growing_plant_edits(PlantChoice const& plant, GrowthOptions const& growth, std::uint64_t seed);

// The scene after the edits of growing_plant_edits(). Fails with a user error if a model's plant
// has no branches.
Result<scene::Scene> growing_plant(std::filesystem::path const& model,
                                   std::vector<scene::Edit> const& edits);

// Loads the chosen plant as a scene: growing_plant_edits() followed by growing_plant(). Fails like
// either.
Result<scene::Scene> load_growing_plant(PlantChoice const& plant, GrowthOptions const& growth,
                                        std::uint64_t seed);

// A recorded drawing and how to read it.
struct DrawingOptions {
    // A log, or a file of strokes (stroke_file.h). Strokes of a file are drawn with the first tool:
    // each shapes the next branch in drawing order.
    std::filesystem::path log {};
    tools::Methods methods {}; // Methods whose tools a log may contain; at least one tool.
    std::optional<std::filesystem::path> rig {}; // Replaces the log's own calibration.
    std::optional<std::string> height {};        // Height scenario in place of the height sensor.
    // Playback speed, 1 is real time; no value: as fast as possible.
    std::optional<double> speed {};
};

// Statistics of a drawing that was read.
struct DrawingReport {
    std::string log;
    std::size_t reports = 0;
    std::size_t broken_reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    std::size_t strokes = 0;
    // Number of paths that strokes shape; a branch selected twice counts once.
    std::size_t branches_selected = 0;
    std::size_t indicators = 0;
    std::vector<std::string> notes; // One sentence for each ineffective stroke or warning.
};

// A drawing, and the resulting scene.
struct Drawing {
    scene::Scene scene;
    std::vector<document::DrawnStroke> strokes;
    Nib nib = Nib::Point; // Nib of the pen that drew the strokes.
};

// Replays a drawing on `scene`, whose base plant is loaded. Fills `report` and adds to its notes.
// Fails with a user or device error if the drawing cannot be read.
Result<Drawing> read_drawing(DrawingOptions const& options, scene::Scene scene,
                             terminal::Progress& progress, DrawingReport& report);

// Replays a drawing in a document that works synchronously. Also fails, with a user error, if the
// document's session cannot be written.
Result<Drawing> read_drawing(DrawingOptions const& options, document::Document& document,
                             terminal::Progress& progress, DrawingReport& report);

// The finished strokes of a recording or of a file of strokes (is_stroke_file()). Fails like
// read_drawing() and load_strokes().
Result<std::vector<Stroke>> drawn_strokes(DrawingOptions const& options);

} // namespace tractus::batch
