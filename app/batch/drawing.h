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
    // Name of a growth preset, one of growth_presets(). No value: the plant of a session grows as
    // saved in it, and any other plant as "usual".
    std::optional<std::string> preset {};
    double variability = 1; // Factor on the random variation of growth; see at_variability().
    // True: branches bend along the ground instead of growing into it; see bend_along_ground().
    bool along_ground = false;
    // Leaves as for foliage_edits(); empty: the leaves saved in the session or model.
    std::string leaves {};
    // Season to show. No value: the season saved in the session, if there is one.
    std::optional<scene::Season> season {};
};

// Name of the growth preset used for the plants of `model`, for reports and manifests.
std::string growth_name(std::filesystem::path const& model, GrowthOptions const& growth);

// A plant to draw on: its file and, if the file is a session, the kinds of edits it may contain.
struct PlantChoice {
    // File of the plant. Empty: an empty sheet, on which the drawing makes all plants.
    std::filesystem::path model;
    scene::EditKinds kinds;
};

// Returns edits that load a plant to draw on and set its growth. The plant's file is a model
// (load_plant_edit()), or a session, of which everything drawn is included. Fails with a user error
// for any other file and for an unknown growth preset.
Result<std::vector<scene::Edit>>
growing_plant_edits(PlantChoice const& plant, GrowthOptions const& growth, std::uint64_t seed);

// Builds the scene from the edits of growing_plant_edits(). Fails with a user error if a model's
// plant has no branches.
Result<scene::Scene> growing_plant(std::filesystem::path const& model,
                                   std::vector<scene::Edit> const& edits);

// Loads the chosen plant as a scene: growing_plant_edits() followed by growing_plant(). Fails like
// those two functions.
Result<scene::Scene> load_growing_plant(PlantChoice const& plant, GrowthOptions const& growth,
                                        std::uint64_t seed);

// A recorded drawing, and options for reading it.
struct DrawingOptions {
    // A log, or a file of strokes (stroke_file.h). The strokes of a file are drawn with the first
    // tool of `methods`: each shapes the next branch, in the order in which the file lists them.
    std::filesystem::path log {};
    tools::Methods methods {}; // Methods whose tools the log may contain; at least one tool.
    // Rig file that replaces the calibration in the log.
    std::optional<std::filesystem::path> rig {};
    std::optional<std::string> height {}; // Height scenario that replaces the height sensor.
    // Playback speed as a multiple of real time. No value: as fast as possible.
    std::optional<double> speed {};
};

// Statistics of a drawing that was read from a log or a file of strokes.
struct DrawingReport {
    std::string log;
    std::size_t reports = 0;
    std::size_t broken_reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    std::size_t strokes = 0;
    // Number of different paths of branches that strokes shape; a path selected twice counts once.
    std::size_t branches_selected = 0;
    std::size_t indicators = 0;
    std::vector<std::string> notes; // One sentence for each ineffective stroke or warning.
};

// The strokes of a drawing, and the scene that results from them.
struct Drawing {
    scene::Scene scene;
    std::vector<document::DrawnStroke> strokes;
    Nib nib = Nib::Point; // Nib of the pen that drew the strokes.
};

// Replays a drawing on `scene`, whose base plant is already loaded. Fills `report` and appends to
// its notes. Fails with a user or device error if the drawing cannot be read.
Result<Drawing> read_drawing(DrawingOptions const& options, scene::Scene scene,
                             terminal::Progress& progress, DrawingReport& report);

// Replays a drawing in a document that works synchronously. Fails like the overload for a scene,
// and with a user error if the document's session cannot be written.
Result<Drawing> read_drawing(DrawingOptions const& options, document::Document& document,
                             terminal::Progress& progress, DrawingReport& report);

// Returns the finished strokes of a recording or of a file of strokes (is_stroke_file()). Fails
// like read_drawing() and load_strokes().
Result<std::vector<Stroke>> drawn_strokes(DrawingOptions const& options);

} // namespace tractus::batch
