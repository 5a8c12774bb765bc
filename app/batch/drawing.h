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

// How plants grow.
struct GrowthOptions {
    // See growth_presets(). Without it a session's plants grow as the session says, and others as
    // "usual".
    std::optional<std::string> preset {};
    double variability = 1;    // See at_variability().
    bool along_ground = false; // See bend_along_ground().
    std::string leaves {};     // See dressing_edits(); empty: as a session or a model says.
    std::optional<scene::Season> season {}; // No value: as a session says, and else without one.
};

// How the plants of `model` grow, in words.
std::string growth_name(std::filesystem::path const& model, GrowthOptions const& growth);

// A plant to be drawn on: its file, and of which kinds its edits may be if that is a session.
struct PlantChoice {
    std::filesystem::path model; // Empty: an empty sheet, on which the drawing makes plants.
    scene::EditKinds kinds;
};

// Returns the edits that load a plant to be drawn on and say how it grows: a model
// (load_plant_edit), or a session with all that was drawn in it. Fails, as the user's fault, for
// what is neither, or a growth that does not exist.
Result<std::vector<scene::Edit>>
growing_plant_edits(PlantChoice const& plant, GrowthOptions const& growth, std::uint64_t seed);

// The scene that such edits give. Fails, as the user's fault, for a model's plant without branches.
Result<scene::Scene> growing_plant(std::filesystem::path const& model,
                                   std::vector<scene::Edit> const& edits);

// Does both: the edits of the choice, and their scene. Fails like either.
Result<scene::Scene> load_growing_plant(PlantChoice const& plant, GrowthOptions const& growth,
                                        std::uint64_t seed);

// A recorded drawing.
struct DrawingOptions {
    // A log, or a file of strokes (stroke_file.h), which are drawn with the first of all tools:
    // each shapes the next branch in drawing order.
    std::filesystem::path log {};
    tools::Methods methods {}; // Methods that a log may name; with at least one tool.
    std::optional<std::filesystem::path> rig {}; // A calibration in place of the log's own.
    std::optional<std::string> height {};        // A height scenario in place of the height sensor.
    std::optional<double> speed {}; // Times the pace of the hand; no value: as fast as it is read.
};

// Facts about a drawing that was read.
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

// A drawing, and the scene that it amounts to.
struct Drawing {
    scene::Scene scene;
    std::vector<document::DrawnStroke> strokes;
    Nib nib = Nib::Point; // How the ink of the strokes looks.
};

// Draws it on `scene`, whose base plant is loaded. Tells `report` what was read, and adds to its
// notes. Fails, as the user's or a device's fault, if it cannot be read.
Result<Drawing> read_drawing(DrawingOptions const& options, scene::Scene scene,
                             terminal::Progress& progress, DrawingReport& report);

// Reads it in a document that works at once. Fails, as the user's fault, too, where its session
// cannot keep something.
Result<Drawing> read_drawing(DrawingOptions const& options, document::Document& document,
                             terminal::Progress& progress, DrawingReport& report);

// The finished strokes of a recording, or of a file of strokes (is_stroke_file()). Fails like
// read_drawing() and load_strokes().
Result<std::vector<Stroke>> drawn_strokes(DrawingOptions const& options);

} // namespace tractus::batch
